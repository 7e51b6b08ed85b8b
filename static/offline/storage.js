/**
 * Whether what is kept stays when the disk gets full: browsers throw away what they were not asked to keep.
 *
 * @returns {Promise<boolean>}
 */
export async function isLasting() {
  return (await navigator.storage?.persisted?.().catch(() => false)) ?? false;
}

/** Ask the browser to throw nothing away. Some ask the user, some decide by themselves. @returns {Promise<boolean>} whether it agreed */
export async function askLasting() {
  if (await isLasting()) return true;
  return (await navigator.storage?.persist?.().catch(() => false)) ?? false;
}

/** Bytes that pages of this origin may keep, all together; null where the browser does not tell. @returns {Promise<number | null>} */
export async function quota() {
  const estimate = await navigator.storage?.estimate?.().catch(() => null);
  return estimate?.quota ?? null;
}
