// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QJsonObject>
#include <QString>
#include <QStringList>
#include <utility>
#include <vector>

#include "cli/bench/harness.h"
#include "core/result.h"

namespace hitscope::bench {

/// A table as people read it: text in columns, the first to the left, all others to the right.
struct Table {
    QString title;
    QStringList columns;
    std::vector<QStringList> rows;  ///< as many entries as columns; fewer: the rest is empty
    QStringList notes;              ///< below it, a line each
};

/// A value with its range, for a diagram. All above 0.
struct Mark {
    QString name;
    double low = 0.0;
    double middle = 0.0;
    double high = 0.0;
    double limit = 0.0;  ///< that it is to keep; 0: none
};

/// What a benchmark found: tables for people, and the same figures as records, all with the same fields, for
/// programs.
struct Report {
    QString benchmark;                                ///< "paper"
    std::vector<std::pair<QString, QString>> header;  ///< name and value, what the figures belong to
    std::vector<Table> tables;
    QStringList fields;  ///< of the records, in the order of the CSV's columns
    QStringList keys;    ///< those that tell one record from another, in reports of the same benchmark too
    /// Besides the fields a record may have "runs", the values of all samples in their order, seconds if
    /// "unit" does not say otherwise; less is better.
    std::vector<QJsonObject> records;
    QStringList notes;  ///< on the whole
    QString along{};    ///< the field over which times are drawn as lines; empty: none
    // What is drawn in place of the runs; empty: these.
    std::vector<Mark> marks{};
    QString marksAxis{};  ///< what the marks are
};

/// Header, tables, notes.
[[nodiscard]] QString toText(const Report& report);
/// {"report": "bench NAME", "header": {name: value}, "fields", "keys", "records": [{field: value, "runs"}],
/// "notes"}. Numbers read back to the same bits. UTF-8.
[[nodiscard]] QByteArray toJson(const Report& report);
/// The header and the notes as lines that start with #, a line of field names, a line a record (RFC 4180,
/// but for line ends: \n). UTF-8.
[[nodiscard]] QByteArray toCsv(const Report& report);

/// Where a report goes. "-" is the standard output.
struct Destinations {
    bool json = false;  ///< as JSON to the standard output
    QString report{};   ///< file for JSON; empty: none
    QString html{};     ///< file; empty: none
    QString csv{};      ///< file; empty: none
    bool quiet = false;

    /// How many of them go there; the tables for people do where there is none.
    [[nodiscard]] int toStandardOutput() const;
    /// Whether the tables for people are wanted.
    [[nodiscard]] bool wantsText() const;
};
/// Fails where a file could not be written, before hours are spent on what goes into it.
[[nodiscard]] Status checkDestinations(const Destinations& destinations);
/// Files are written whole or not at all.
[[nodiscard]] Status writeReport(const Report& report, const Destinations& destinations);

/// What a record has as "runs".
[[nodiscard]] QJsonArray runsJson(const Samples& samples);

/// Three significant digits or so, without an exponent: "1234", "123", "12.3", "0.0123".
[[nodiscard]] QString shortNumber(double value);
/// Like "12.3 µs", "4.56 ms", "1.23 s".
[[nodiscard]] QString shortTime(double seconds);
/// 1000000 as "1,000,000".
[[nodiscard]] QString grouped(qulonglong value);

}  // namespace hitscope::bench
