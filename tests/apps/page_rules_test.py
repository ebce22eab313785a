# SPDX-License-Identifier: MIT
"""Is each fault of a page found, and a good page left in peace?"""
import pathlib
import tempfile
import unittest

import page_rules

GOOD = """<!DOCTYPE html>
<html lang="en"><head><title>t</title><link rel="icon" href="data:,"><style>a { color: red; }</style></head>
<body><p id="p"><a href="#p">up</a> <a href="a%20b.csv">data</a>
<img src="data:," alt="a" width="1" height="1"><input id="i"><label for="i">i</label></p></body></html>
"""


class PageRules(unittest.TestCase):
    def faults(self, text):
        with tempfile.TemporaryDirectory(prefix="penumbra-") as folder:
            page = pathlib.Path(folder, "index.html")
            page.write_text(text, encoding="utf-8")
            pathlib.Path(folder, "a b.csv").touch()
            return page_rules.faults(page)

    def test_a_good_page_has_none(self):
        self.assertEqual(self.faults(GOOD), [])

    def test_each_fault_is_found_alone(self):
        for old, new, fault in [
            ("<!DOCTYPE html>\n", "", "DOCTYPE"),
            ("</p>", "", "is open"),
            ("</html>", "", "stays open"),
            ('<input id="i">', '<input id="i"><b id="p"></b>', "used twice"),
            ('href="#p"', 'href="#q"', "leads nowhere"),
            ("a%20b.csv", "b.csv", "not beside"),
            ('for="i"', 'for="j"', "a label for 'j'"),
            ('src="data:,"', 'src="x.png"', "not inside the page"),
            ('src="data:,"', 'src="https://example.org/x.png"', "not inside the page"),
            (' alt="a"', "", "without a text"),
            (' width="1"', "", "without its size"),
            ("<body>", '<body><table><tr><th>x</th></tr></table>', "without scope"),
            ('href="data:,"', 'href="style.css"', "loads style.css"),
            ("color: red", "background: url(x.png)", "style sheet"),
            ('<p id="p">', '<p id="p" lang="en" lang="de">', "twice"),
        ]:
            with self.subTest(fault=fault, new=new):
                self.assertIn(old, GOOD)
                found = self.faults(GOOD.replace(old, new, 1))
                self.assertEqual(len(found), 1, found)
                self.assertIn(fault, found[0])


if __name__ == "__main__":
    unittest.main()
