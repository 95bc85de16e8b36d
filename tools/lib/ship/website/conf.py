"""The configuration of Sphinx for the site of tools/make site, which copies it beside the pages."""

project = "hashnoise"
copyright = "The hashnoise authors"
extensions = ["myst_parser"]
myst_heading_anchors = 6  # links to headings are those of GitHub
html_theme = "furo"
html_title = "hashnoise"
html_copy_source = False
html_show_sourcelink = False
html_extra_path = ["extra"]
highlight_language = "none"
suppress_warnings = ["misc.highlighting_failure"]  # Pygments does not know every language of shaders
