// SPDX-License-Identifier: MIT
#include "page_style.h"

#include <fmt/format.h>

#include <string_view>

namespace penumbra::reproduce {
namespace {

constexpr const char* text_style = R"css(
:root {
  color-scheme: light;
  --ink: #1b1f24; --soft: #5a636e; --rule: #d5d9de; --strong-rule: #1b1f24;
  --paper: #9a3412; --link: #0b57a4; --tint: #f4f6f8; --back: #fff;
  --text: 42rem;
}
*, *::before, *::after { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; text-size-adjust: 100%; scroll-padding-top: 1rem; }
body {
  margin: 0 auto; padding: 0 1.25rem 4rem; max-width: 76rem; color: var(--ink);
  background: var(--back); overflow-wrap: break-word;
  font: 1rem/1.6 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
}
a { color: var(--link); text-decoration-thickness: 1px; text-underline-offset: 0.15em; }
a:hover { text-decoration-thickness: 2px; }
:focus-visible { outline: 3px solid #f0a500; outline-offset: 2px; border-radius: 2px; }
p, li, dd { max-width: var(--text); }
h1, h2 { line-height: 1.2; letter-spacing: -0.01em; text-wrap: balance; }
h1 { margin: 0; font-size: clamp(1.6rem, 1.1rem + 2vw, 2.4rem); max-width: 24em; }
h2 { margin: 0 0 0.75rem; font-size: 1.4rem; }
header { padding: clamp(1.75rem, 5vw, 3.5rem) 0 0; }
.subtitle { margin: 0.75rem 0 0; color: var(--soft); font-size: 1.125rem; }
.setting { margin: 2rem 0 0; padding: 0; border-top: 1px solid var(--rule); font-size: 0.9375rem; }
.setting > div {
  display: grid; grid-template-columns: 11rem 1fr; gap: 0 1.5rem; padding: 0.4rem 0;
  border-bottom: 1px solid var(--rule);
}
.setting dt { color: var(--soft); }
.setting dd { margin: 0; min-width: 0; max-width: none; overflow-wrap: anywhere; }
.legend { margin: 1.25rem 0 0; font-size: 0.9375rem; }
.legend .ours { font-weight: 600; }
.paper { color: var(--paper); font-style: italic; }
nav { margin: 2rem 0 0; font-size: 0.9375rem; line-height: 1.45; }
nav h2 {
  margin: 0 0 0.5rem; color: var(--soft); font-size: 0.8125rem; font-weight: 600;
  letter-spacing: 0.02em;
}
nav ol, nav ul { margin: 0; padding: 0; list-style: none; }
nav li { margin: 0 0 0.5rem; }
nav a { display: inline-block; text-decoration: none; }
nav a:hover { text-decoration: underline; }
nav ul { display: flex; flex-wrap: wrap; gap: 0 0.9rem; margin-top: 0.1rem; }
nav ul li { margin: 0; font-size: 0.8125rem; }
nav ul a { padding: 0.15rem 0; color: var(--soft); }
section { padding-top: 2.75rem; }
section > p { margin: 0 0 1rem; }
.notes { margin: 1.5rem 0 0; padding-left: 1.2rem; font-size: 0.9375rem; }
.notes li { margin-bottom: 0.4rem; }
.files { margin: 0.35rem 0 0; color: var(--soft); font-size: 0.8125rem; overflow-wrap: anywhere; }
caption strong, figcaption strong { font-weight: 650; }
caption span, figcaption span { color: var(--soft); }
@media (max-width: 34rem) {
  body { padding: 0 1rem 3rem; }
  .setting > div { grid-template-columns: 1fr; }
}
@media (min-width: 70rem) {
  body { display: grid; grid-template-columns: 12.5rem minmax(0, 1fr); column-gap: 3.5rem; }
  header { grid-column: 2; }
  nav {
    grid-column: 1; grid-row: 1 / span 2; position: sticky; top: 0; align-self: start;
    max-height: 100vh; margin: 0; padding: 3.9rem 0 2rem; overflow-y: auto;
  }
  nav ul { display: block; }
  main { grid-column: 2; }
}
)css";

constexpr const char* table_style = R"css(
.sheet { margin: 1.75rem 0 2.5rem; }
table {
  border-collapse: collapse; font-size: 0.875rem; line-height: 1.4;
  font-variant-numeric: tabular-nums lining-nums;
}
table.few { min-width: min(100%, 28rem); }
table.some { min-width: min(100%, var(--text)); }
table.many { width: 100%; }
table.many { font-size: 0.8125rem; }
caption { padding: 0 0 0.6rem; text-align: left; font-size: 0.9375rem; line-height: 1.5; }
th, td { padding: 0.45rem 0.6rem; text-align: right; vertical-align: top; }
table.many th, table.many td { padding-inline: 0.4rem; }
tr > :first-child { padding-left: 0.5rem; text-align: left; }
thead th {
  border-block: 1.5px solid var(--strong-rule) ; border-bottom-width: 1px; vertical-align: bottom;
  font-weight: 600; line-height: 1.3;
}
tbody th { min-width: 7rem; font-weight: 400; overflow-wrap: anywhere; }
tbody tr + tr { border-top: 1px solid var(--rule); }
table > tbody:last-child { border-bottom: 1.5px solid var(--strong-rule); }
td span, td small { display: block; white-space: nowrap; }
td .paper { margin-right: -0.39em; }  /* figures stand under figures */
td small { color: var(--soft); font-size: 0.75rem; }
.beyond { background: var(--tint); border-top: 1px solid var(--strong-rule); }
.beyond .divider th {
  padding-bottom: 0; color: var(--soft); font-size: 0.75rem; font-weight: 600; text-align: left;
}
.beyond .divider + tr { border-top: 0; }
)css";

/// On narrow screens each row is a card, each cell a line of it. KIND is a class of tables.
constexpr const char* card_style = R"css(
  table.KIND, .KIND tbody, .KIND tr, .KIND th, .KIND td, .KIND caption { display: block; }
  table.KIND { font-size: 0.875rem; }
  .KIND thead {
    position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%);
  }
  .KIND tbody tr { padding: 0.7rem 0; border-top: 1px solid var(--strong-rule); }
  .KIND tbody th { padding: 0 0 0.25rem; font-weight: 650; }
  table.KIND td {
    display: flex; justify-content: space-between; gap: 1rem; padding: 0.2rem 0;
  }
  .KIND td::before { min-width: 0; content: attr(data-label); color: var(--soft); }
  .KIND td > div {
    display: flex; flex-wrap: wrap; justify-content: flex-end; align-items: baseline;
    gap: 0 0.5rem; max-width: 70%;
  }
  .KIND td .paper { min-width: 4.25rem; margin: 0; }
  .KIND.compared td > div:not(:has(.paper)) { padding-right: 4.75rem; }
  .KIND td span, .KIND td small { white-space: normal; }
  table.KIND .none { display: none; }
  table.KIND .beyond tr > * { padding-inline: 0.6rem; }
  .KIND .beyond tr.divider { padding-bottom: 0; }
  .KIND .beyond .divider + tr { padding-top: 0.35rem; border-top: 0; }
)css";

constexpr const char* figure_style = R"css(
figure { margin: 0; min-width: 0; }
img { display: block; max-width: 100%; height: auto; }
figcaption { max-width: var(--text); margin-top: 0.6rem; font-size: 0.9375rem; line-height: 1.5; }
.galleries { display: grid; gap: 2.25rem 2rem; margin: 1.75rem 0 2.5rem; }
fieldset { min-width: 0; margin: 0; padding: 0; border: 0; }
.gallery legend, .gallery input, .view .name {
  position: absolute; width: 1px; height: 1px; margin: -1px; overflow: hidden;
  clip-path: inset(50%); white-space: nowrap;
}
.gallery label {
  display: inline-block; margin: 0 0.35rem 0.5rem 0; padding: 0.3rem 0.75rem; cursor: pointer;
  border: 1px solid #8a939e; border-radius: 0.3rem; font-size: 0.875rem; line-height: 1.4;
}
.gallery label:hover { background: var(--tint); }
.gallery input:checked + label { border-color: var(--ink); background: var(--ink); color: #fff; }
.gallery input:focus-visible + label { outline: 3px solid #f0a500; outline-offset: 2px; }
.frame { display: grid; grid-template-columns: minmax(0, 1fr); margin-top: 0.15rem; }
.view { grid-area: 1 / 1; visibility: hidden; }
.frame .view:only-child { visibility: visible; }
.view img { width: 100%; background: var(--tint); }
.plots { display: grid; gap: 2.5rem 2rem; margin: 1.75rem 0 2.5rem; }
.plot img { width: 100%; max-width: 40rem; }
@media (min-width: 48rem) {
  .plots, .galleries { grid-template-columns: repeat(2, minmax(0, 1fr)); }
  .gallery:only-child, .plot:only-child { grid-column: 1 / -1; max-width: 42rem; }
}
@media (max-width: 34rem) {
  .plot img { width: calc(100% + 2rem); max-width: none; margin-inline: -1rem; }
}
)css";

constexpr const char* print_style = R"css(
@media print {
  @page { margin: 18mm 15mm; }
  html { font-size: 9.5pt; }
  body { display: block; max-width: none; padding: 0; }
  nav, .gallery label { display: none; }
  a { color: inherit; text-decoration: none; }
  h2 { break-after: avoid; }
  .plot, .view, tr, caption { break-inside: avoid; }
  thead { display: table-header-group; }
  .frame { grid-template-columns: repeat(2, minmax(0, 1fr)); gap: 4mm; }
  .frame .view { grid-area: auto; visibility: visible; }
  .view .name { position: static; width: auto; height: auto; margin: 0; clip-path: none; }
  .plots { grid-template-columns: repeat(2, minmax(0, 1fr)); }
  .galleries { display: block; }
  table.many { font-size: 7.5pt; }
  table.many td span, table.many td small { white-space: normal; }
  .beyond { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)css";

std::string cards(std::string_view kind, int most_rem) {
  constexpr std::string_view name = "KIND";
  std::string rules = card_style;
  for (auto at = rules.find(name); at != rules.npos; at = rules.find(name, at))
    rules.replace(at, name.size(), kind);
  return fmt::format("@media screen and (max-width: {}rem) {{{}}}\n", most_rem, rules);
}

}  // namespace

std::string page_style() {
  return text_style + std::string(table_style) + cards("some", 44) + cards("many", 60) +
         figure_style + print_style;
}

}  // namespace penumbra::reproduce
