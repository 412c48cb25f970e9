// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/reports/html_report.h"

#include <QXmlStreamWriter>

#include "cli/bench/reports/diagrams.h"

namespace hitscope::bench {

namespace {

/// Colours of lines: P. Tol's "vibrant" and "bright" schemes, which people with other colour vision tell
/// apart.
const QString kStyle = QStringLiteral(R"(
:root { color-scheme: light dark; --back: #ffffff; --text: #1b1f24; --faint: #57606a; --rule: #d0d7de; --band: #f3f5f7;
  --c0: #0b63b0; --c1: #c8380d; --c2: #00796b; --c3: #8a6d00; --c4: #a3195b; --c5: #555555; --limit: #b00020; }
@media (prefers-color-scheme: dark) { :root { --back: #14171a; --text: #e6e9ec; --faint: #9aa4ae; --rule: #3a424a;
  --band: #1d2226; --c0: #62b0f5; --c1: #ff8a5c; --c2: #4ccdb9; --c3: #e2c044; --c4: #f078b4; --c5: #b8b8b8; --limit: #ff6b7f; } }
body { margin: 2rem auto; max-width: 72rem; padding: 0 1rem; background: var(--back); color: var(--text);
  font: 15px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.15rem; margin-top: 2rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: 0.2rem 0.7rem; text-align: right; border-bottom: 1px solid var(--rule); white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
th { font-weight: 600; vertical-align: bottom; white-space: normal; }
tbody tr:nth-child(even) { background: var(--band); }
.header td { white-space: normal; text-align: left; } .header td:first-child { color: var(--faint); }
p.note { color: var(--faint); max-width: 60rem; }
svg { display: block; max-width: 100%; height: auto; margin: 0.5rem 0; }
svg text { fill: var(--text); font: 12px system-ui, sans-serif; } svg .faint { fill: var(--faint); }
svg .grid { stroke: var(--rule); stroke-width: 1; } svg .limit { stroke: var(--limit); stroke-width: 2; }
svg .l0 { stroke: var(--c0); } svg .l1 { stroke: var(--c1); } svg .l2 { stroke: var(--c2); }
svg .l3 { stroke: var(--c3); } svg .l4 { stroke: var(--c4); } svg .l5 { stroke: var(--c5); }
svg .f0 { fill: var(--c0); } svg .f1 { fill: var(--c1); } svg .f2 { fill: var(--c2); }
svg .f3 { fill: var(--c3); } svg .f4 { fill: var(--c4); } svg .f5 { fill: var(--c5); }
svg .line { fill: none; stroke-width: 2; } svg .dashed { stroke-dasharray: 7 5; }
)");

void writeCells(QXmlStreamWriter& xml, const QString& element, const QStringList& cells, qsizetype count) {
    xml.writeStartElement(QStringLiteral("tr"));
    for (qsizetype column = 0; column < count; ++column) {
        xml.writeTextElement(element, cells.value(column));
    }
    xml.writeEndElement();
}

void writeNotes(QXmlStreamWriter& xml, const QStringList& notes) {
    for (const QString& note : notes) {
        xml.writeStartElement(QStringLiteral("p"));
        xml.writeAttribute(QStringLiteral("class"), QStringLiteral("note"));
        xml.writeCharacters(note);
        xml.writeEndElement();
    }
}

void writeTable(QXmlStreamWriter& xml, const Table& table) {
    xml.writeTextElement(QStringLiteral("h2"), table.title);
    xml.writeStartElement(QStringLiteral("div"));
    xml.writeAttribute(QStringLiteral("class"), QStringLiteral("wide"));
    xml.writeStartElement(QStringLiteral("table"));
    xml.writeStartElement(QStringLiteral("thead"));
    writeCells(xml, QStringLiteral("th"), table.columns, table.columns.size());
    xml.writeEndElement();
    xml.writeStartElement(QStringLiteral("tbody"));
    for (const QStringList& row : table.rows) {
        writeCells(xml, QStringLiteral("td"), row, table.columns.size());
    }
    xml.writeEndElement();
    xml.writeEndElement();
    xml.writeEndElement();
    writeNotes(xml, table.notes);
}

void writeHeader(QXmlStreamWriter& xml, const Report& report) {
    xml.writeStartElement(QStringLiteral("table"));
    xml.writeAttribute(QStringLiteral("class"), QStringLiteral("header"));
    for (const auto& [name, value] : report.header) {
        writeCells(xml, QStringLiteral("td"), {name, value}, 2);
    }
    xml.writeEndElement();
}

}  // namespace

QByteArray toHtml(const Report& report) {
    const QString title = QStringLiteral("Hitscope: bench ") + report.benchmark;
    QByteArray page;
    QXmlStreamWriter xml(&page);
    xml.writeDTD(QStringLiteral("<!DOCTYPE html>\n"));
    xml.writeStartElement(QStringLiteral("html"));
    xml.writeAttribute(QStringLiteral("lang"), QStringLiteral("en"));
    xml.writeStartElement(QStringLiteral("head"));
    xml.writeEmptyElement(QStringLiteral("meta"));
    xml.writeAttribute(QStringLiteral("charset"), QStringLiteral("utf-8"));
    xml.writeEmptyElement(QStringLiteral("meta"));
    xml.writeAttribute(QStringLiteral("name"), QStringLiteral("viewport"));
    xml.writeAttribute(QStringLiteral("content"), QStringLiteral("width=device-width"));
    xml.writeTextElement(QStringLiteral("title"), title);
    xml.writeTextElement(QStringLiteral("style"), kStyle);
    xml.writeEndElement();
    xml.writeStartElement(QStringLiteral("body"));
    xml.writeTextElement(QStringLiteral("h1"), title);
    writeHeader(xml, report);
    writeDiagrams(xml, report);
    for (const Table& table : report.tables) {
        writeTable(xml, table);
    }
    writeNotes(xml, report.notes);
    xml.writeEndElement();
    xml.writeEndElement();
    xml.writeCharacters(QStringLiteral("\n"));
    return page;
}

}  // namespace hitscope::bench
