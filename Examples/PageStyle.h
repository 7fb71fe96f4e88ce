// SPDX-License-Identifier: BSD-3-Clause
#ifndef PageStyle_h
#define PageStyle_h

/// How report.html looks: one column on a narrow screen; paper gets no page breaks within pictures and tables.
constexpr const char* PageStyle = R"(
body { font: 16px/1.5 system-ui, "Liberation Sans", Arial, sans-serif; color: #1f2937; background: #fff;
  max-width: 1080px; margin: 0 auto; padding: 1rem; overflow-wrap: break-word; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: .5rem 0; }
h2 { font-size: 1.25rem; margin: 2rem 0 .5rem; }
p, ul { max-width: 46rem; }
.verdict { border-left: .5rem solid #1d4ed8; background: #eff6ff; padding: .5rem 1rem; margin: 1rem 0; }
.verdict.doubtful { border-color: #c2410c; background: #fff7ed; }
.verdict h2 { margin: .25rem 0; }
.verdict h3 { font-size: 1rem; margin: .75rem 0 0; }
.side { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 19rem), 1fr)); gap: 1rem 1.5rem; }
figure { margin: 0; }
figure img, svg { display: block; width: 100%; height: auto; }
figcaption { font-size: .9rem; color: #4b5563; margin: .25rem 0 .5rem; }
.table { overflow-x: auto; }
table { border-collapse: collapse; margin: .75rem 0; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding-bottom: .25rem; }
th, td { padding: .25rem .75rem .25rem 0; text-align: right; border-bottom: 1px solid #d1d5db; white-space: nowrap; }
th:first-child { text-align: left; white-space: normal; }
tbody th { font-weight: 400; }
.meaning { display: block; min-width: 14rem; max-width: 30rem; white-space: normal; text-align: left; }
footer { font-size: .9rem; color: #4b5563; }
svg text { font: 15px system-ui, "Liberation Sans", Arial, sans-serif; fill: #1f2937; }
svg .axis { stroke: #1f2937; }
svg .grid { stroke: #d1d5db; }
svg .mean { stroke: #1f2937; stroke-width: 2; stroke-dasharray: 5 4; }
sup { line-height: 0; }
@media (max-width: 30rem) {
  th, td { padding-right: .4rem; }
}
@media print {
  body { font-size: 11pt; max-width: none; padding: 0; }
  figure, tr, .verdict, .side .table { break-inside: avoid; }
  .side { grid-template-columns: repeat(auto-fit, minmax(13rem, 1fr)); }
  h2 { break-after: avoid; }
  .verdict, svg { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)";

#endif
