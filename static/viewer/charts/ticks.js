/** Round values (1, 2, 5 times a power of ten) between two ends. @param {number} low @param {number} high @param {number} about how many */
export function niceTicks(low, high, about) {
  if (!(high > low)) return [low];
  const parts = Math.max(1, about);
  const rough = high / parts - low / parts;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= rough) ?? 10);
  const ticks = [];
  const last = Math.floor(high / step + 1e-9);
  for (let index = Math.ceil(low / step - 1e-9); index <= last; index++) ticks.push(index * step || 0);
  return ticks;
}

/** A tick's value in as few digits as it needs. @param {number} value */
export function tickText(value) {
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e5))
    return Number(value.toPrecision(3)).toExponential().replace("e+", "e").replaceAll("-", "−");
  return String(Number(value.toPrecision(4))).replace("-", "−");
}
