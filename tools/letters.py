#!/usr/bin/env python3
"""Outlines of single characters of the page's serif font, for regions in the form of a letter: www/letters.json.

Run by hand when the font changes: pip install fonttools brotli skia-pathops; python3 tools/letters.py
"""
import json
from pathlib import Path

import pathops
from fontTools.pens.svgPathPen import SVGPathPen
from fontTools.pens.transformPen import TransformPen
from fontTools.ttLib import TTFont
from fontTools.varLib.instancer import instantiateVariableFont

ROOT = Path(__file__).parent.parent / "www"
CHARACTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789&?!@$€£%ßæøÆØ"
WEIGHT = 500

font = TTFont(ROOT / "fonts/newsreader-latin-wght-normal.woff2")
font = instantiateVariableFont(font, {axis.axisTag: WEIGHT if axis.axisTag == "wght" else axis.defaultValue for axis in font["fvar"].axes})
glyphs, names = font.getGlyphSet(), font.getBestCmap()
scale = 1 / font["OS/2"].sCapHeight


def outline(character):
    """The largest contour of a glyph, capitals being 1 high, and the holes in it."""
    path = pathops.Path()
    glyphs[names[ord(character)]].draw(path.getPen(glyphSet=glyphs))
    path.simplify(fix_winding=True, keep_starting_points=True)
    contours = sorted(path.contours, key=lambda contour: -abs(contour.area))
    box = contours[0].bounds
    inside = [c for c in contours[1:] if box[0] < c.bounds[0] and c.bounds[2] < box[2] and box[1] < c.bounds[1] and c.bounds[3] < box[3]]
    return [commands(contour) for contour in [contours[0], *inside]]


def commands(contour):
    """A contour as the data of an SVG path, y up."""
    pen = SVGPathPen(None, ntos=lambda x: f"{x:.4f}".rstrip("0").rstrip("."))
    contour.draw(TransformPen(pen, (scale, 0, 0, scale, 0, 0)))
    return pen.getCommands()


letters = {character: outline(character) for character in CHARACTERS if ord(character) in names}
lines = ",\n".join(f"{json.dumps(character, ensure_ascii=False)}: {json.dumps(found)}" for character, found in letters.items())
(ROOT / "letters.json").write_text("{\n" + lines + "\n}\n")
print(len(letters), "letters")
