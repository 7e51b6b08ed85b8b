"""Who shows the viewer outside of a static site's own pages: a server on this machine, a headless browser.

Nothing here is shipped to the browser.
"""
