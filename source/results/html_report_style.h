// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_results_html_report_style_h
#define squeal_source_results_html_report_style_h

namespace squeal
{
  /** How the report looks. */
  constexpr char report_style[] = R"(
:root { --ink: #1d2733; --faint: #5b6775; --rule: #d9dee4; --good: #00795a;
  --bad: #b84a00; --neutral: #0072b2; }
* { box-sizing: border-box; }
body { margin: 0; background: #f4f6f8; color: var(--ink);
  font: 15px/1.5 "DejaVu Sans", "Segoe UI", Helvetica, Arial, sans-serif; }
main { max-width: 1180px; margin: 0 auto; padding: 2rem 2.5rem 3rem;
  background: #fff; }
h1 { font-size: 1.8rem; margin: 0; }
.subtitle { color: var(--faint); margin: .2rem 0 1.4rem; }
h2 { font-size: 1.25rem; margin: 2.4rem 0 .8rem; padding-bottom: .25rem;
  border-bottom: 2px solid var(--rule); }
.verdict { border-left: .5rem solid var(--neutral); background: #f4f7fa;
  padding: 1rem 1.3rem; }
.verdict.good { border-color: var(--good); }
.verdict.bad { border-color: var(--bad); background: #fdf3ec; }
.verdict strong { font-size: 1.35rem; color: var(--neutral); }
.verdict.good strong { color: var(--good); }
.verdict.bad strong { color: var(--bad); }
.figures { display: flex; flex-wrap: wrap; gap: .5rem 2.2rem; margin: .7rem 0 0; }
.figures div { min-width: 8rem; }
.figures dt { color: var(--faint); font-size: .82rem; }
.figures dd { margin: 0; font-weight: 600; }
nav { margin: 1.2rem 0 0; font-size: .9rem; }
nav a { color: var(--neutral); text-decoration: none; margin-right: 1.1rem; }
/* A table that goes on beyond the right edge has a shadow there: a cover that
   moves with the table hides it at the end. */
.wide { overflow-x: auto; background:
  linear-gradient(to left, #fff 40%, #fff0) 100% 0 / 3rem 100% local no-repeat,
  linear-gradient(to left, #1d273340, #fff0) 100% 0 / 1rem 100% scroll
    no-repeat; }
table { border-collapse: collapse; font-size: .84rem; margin: .4rem 0; }
caption { text-align: left; color: var(--faint); padding-bottom: .4rem; }
th { text-align: left; vertical-align: bottom; font-weight: 600;
  border-bottom: 2px solid var(--ink); padding: .25rem .7rem .25rem 0; }
th small { display: block; font-weight: 400; color: var(--faint); }
td { border-bottom: 1px solid var(--rule); padding: .2rem .7rem .2rem 0;
  vertical-align: top; }
th.number { text-align: right; padding-left: .7rem; vertical-align: bottom; }
td.number { text-align: right;
  font-variant-numeric: tabular-nums; padding-left: .7rem; }
tr.marked td { background: #fdeadd; font-weight: 600; }
table.data td { white-space: nowrap; max-width: 26em; overflow: hidden;
  text-overflow: ellipsis; }
table.data th { cursor: pointer; }
table.data th[aria-sort="ascending"]::after { content: " \25b4"; }
table.data th[aria-sort="descending"]::after { content: " \25be"; }
/* Columns beyond those that fit fold out. */
.more { display: none; }
.fold:checked ~ .wide .more { display: table-cell; }
.table { margin: 1rem 0; font-size: .82rem; }
.table label, .table a, figcaption a { color: var(--neutral); }
.table label { cursor: pointer; margin-right: 1.1rem; }
details summary { color: var(--faint); font-size: .82rem; cursor: pointer; }
/* What a row is about stays in sight. */
.wide th:first-child, .wide td:first-child { position: sticky; left: 0;
  background: #fff; }
.wide tr.marked td:first-child { background: #fdeadd; }
td.ok { color: var(--good); font-weight: 600; }
td.failed { color: var(--bad); font-weight: 600; }
dl.legend { font-size: .8rem; color: var(--faint); columns: 2; margin: .3rem 0; }
dl.legend div { break-inside: avoid; }
dl.legend dt { display: inline; font-weight: 600; }
dl.legend dd { display: inline; margin: 0; }
dl.legend dd::after { content: ""; display: block; }
/* Two columns: a tall chart leaves no gap beside it. */
.row { columns: 2; column-gap: 2%; margin: 1rem 0; }
figure { margin: 1rem 0; width: 100%; }
figure.narrow { margin: 0; padding-bottom: 1rem; break-inside: avoid; }
figure img { width: 100%; border: 1px solid var(--rule); }
figcaption { color: var(--faint); font-size: .86rem; }
pre { background: #f4f7fa; padding: .8rem 1rem; overflow-x: auto;
  font-size: .86rem; }
table.pairs td:first-child { color: var(--faint); }
table.pairs td { overflow-wrap: anywhere; }
@media print { body { background: #fff; font-size: 10.5pt; }
  main { padding: 0; max-width: none; } nav { display: none; }
  figure, tr, .verdict, pre { break-inside: avoid; } h2 { break-after: avoid; }
  .wide { overflow: visible; background: none; } table { font-size: 7.5pt; }
  .fold, .table label { display: none; }
  table.data td { white-space: normal; } th, td { padding-right: .35rem; }
  td.number, th.number { padding-left: .2rem; } }
)";

  /** A click on a heading, or Enter, sorts by its column: numbers as numbers,
   * empty cells last. */
  constexpr char sorting_script[] = R"(<script>
document.querySelectorAll("table.data th").forEach(function (head) {
  function sort() {
    var body = head.closest("table").tBodies[0], c = head.cellIndex;
    var up = head.getAttribute("aria-sort") !== "ascending";
    var numbers = head.classList.contains("number");
    function key(row) { return row.cells[c].textContent.trim(); }
    var rows = Array.from(body.rows).sort(function (a, b) {
      var x = key(a), y = key(b);
      if (!x || !y) return (x ? 0 : 1) - (y ? 0 : 1);
      var d = numbers ? parseFloat(x) - parseFloat(y)
                      : x.localeCompare(y, undefined, { numeric: true });
      return up ? d : -d;
    });
    Array.from(head.parentNode.cells).forEach(function (other) {
      other.removeAttribute("aria-sort");
    });
    head.setAttribute("aria-sort", up ? "ascending" : "descending");
    rows.forEach(function (row) { body.appendChild(row); });
  }
  head.tabIndex = 0;
  head.addEventListener("click", sort);
  head.addEventListener("keydown", function (event) {
    if (event.key === "Enter") sort();
  });
});
</script>
)";
} // namespace squeal

#endif
