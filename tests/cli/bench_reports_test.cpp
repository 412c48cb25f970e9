// SPDX-License-Identifier: GPL-3.0-or-later
// What benchmarks write, as their schemas and pages have it, and what comparing two reports says.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <algorithm>

#include "cli/run_cli.h"
#include "cli/scene_files.h"
#include "support/test_program.h"

namespace hitscope::bench_reports_test {

using namespace test;

namespace {

/// A report with these rows; `runs` are JSON.
QByteArray reportOf(const std::vector<std::pair<const char*, QByteArray>>& rows,
                    const QByteArray& benchmark = "session") {
    QByteArray records;
    for (const auto& [name, runs] : rows) {
        records += records.isEmpty() ? "" : ",";
        records += QByteArray("{\"hits\": 7, \"measured\": \"") + name + "\", \"runs\": " + runs + "}";
    }
    return "{\"report\": \"bench " + benchmark +
           "\", \"header\": {\"renderer\": \"pencil\"}, \"fields\": [\"hits\", \"measured\"], \"keys\": "
           "[\"hits\", "
           "\"measured\"], \"records\": [" +
           records + "], \"notes\": []}";
}

/// The texts of all cells below the heads of tables, how many rows they are in, and whether the page can be
/// read to its end.
struct Page {
    QStringList cells;
    int rows = 0;
    int drawings = 0;
    QString error;
};

Page readPage(const QByteArray& html) {
    Page page;
    QXmlStreamReader xml(html);
    bool isNewRow = false;
    while (!xml.atEnd()) {
        if (xml.readNext() == QXmlStreamReader::StartElement) {
            if (xml.name() == QLatin1String("tr")) {
                isNewRow = true;
            } else if (xml.name() == QLatin1String("td")) {
                page.rows += isNewRow ? 1 : 0;
                isNewRow = false;
                page.cells << xml.readElementText().trimmed();
            } else if (xml.name() == QLatin1String("svg")) {
                ++page.drawings;
            }
        }
    }
    page.error = xml.errorString();
    return page;
}

}  // namespace

class BenchReportsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyReportIsAsItsSchemaAndItsPage_data();
    void everyReportIsAsItsSchemaAndItsPage();
    void knownRatios();
    void orderStatistics();
    void toleranceDecides();
    void badReports_data();
    void badReports();

private:
    [[nodiscard]] QString in(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    [[nodiscard]] QByteArray read(const char* name) const {
        QFile file(in(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    /// Rows by their names, of --json.
    [[nodiscard]] QJsonObject compared(const QStringList& options, int status) const {
        const CliRun run =
            runCli(QStringList{"bench", "compare", "--json"} + options << in("a.json") << in("b.json"));
        if (run.status != status) {
            qWarning("%d %s", run.status, qPrintable(run.err));
            return {};
        }
        QJsonObject rows;
        for (const auto& record : QJsonDocument::fromJson(run.out.toUtf8()).object()["records"].toArray()) {
            rows.insert(record.toObject()["row"].toString(), record);
        }
        return rows;
    }
    QTemporaryDir m_folder;
};

void BenchReportsTest::everyReportIsAsItsSchemaAndItsPage_data() {
    QTest::addColumn<QString>("line");
    for (const char* line :
         {"paper --quick --rows 6 --size 64x36 --pipelines uniform-array,transform-feedback",
          "frame --quick --vertices 500 --hits 0,50 --size 64x36 --pipelines compute,reference",
          "modes --quick --row 6 --size 64x36 --pipelines transform-feedback",
          "hit --quick --vertices 1K,2K --hits-a-frame 1 --pipelines transform-feedback",
          "physics --quick --triangles 500 --size 64x36", "session --quick --hits 100",
          "io --quick --quads 900 --triangles 200 --size 64x36",
          "check --quick --only paper-way-8k,projectiles",
          "latency --frames 1 --vertices 500 --size 400x300 --scattered 0",
          "memory --vertices 500 --size 400x300 --hits 3"}) {
        QTest::newRow(line) << QString::fromLatin1(line);
    }
    const QByteArray rows = reportOf({{"save", "[0.1, 0.11, 0.12]"}, {"open & <read>", "[2, 2.5]"}});
    writeBytes(in("one.json"), rows);
    writeBytes(in("two.json"), rows);
    QTest::newRow("compare") << QStringLiteral("compare %1 %2").arg(in("one.json"), in("two.json"));
}

void BenchReportsTest::everyReportIsAsItsSchemaAndItsPage() {
    QFETCH(QString, line);
    const QString name = line.section(u' ', 0, 0);
    const CliRun run = runCli(QStringList{"bench"} + line.split(u' ') +
                              QStringList{"--report", in("r.json")} + QStringList{"--html", in("r.html")});
    if (run.status == 4 && run.err.contains(QStringLiteral("install Xvfb"))) {
        QSKIP("no Xvfb");
    }
    QVERIFY2(run.status == 0, qPrintable(run.err));
    const QJsonObject json = QJsonDocument::fromJson(read("r.json")).object();
    QCOMPARE(json["report"].toString(), QStringLiteral("bench ") + name);

    const QByteArray html = read("r.html");
    const Page page = readPage(html);
    QVERIFY2(page.error.isEmpty(), qPrintable(page.error));
    QCOMPARE(page.drawings >= 1, name != QStringLiteral("memory"));  // drawings show times and rates
    QVERIFY(!html.contains("<script") && !html.contains("href=") && !html.contains("src="));
    QVERIFY(html.contains("prefers-color-scheme: dark"));
    for (const QJsonValue& value : json["header"].toObject()) {
        QVERIFY2(page.cells.contains(value.toString()), qPrintable(value.toString()));
    }
    // What the tables for people have, the page has: below a title and a head, lines of words far apart.
    int rows = 0;
    for (const QString& block : run.out.split(QStringLiteral("\n\n")).mid(1)) {
        for (const QString& text : block.split(u'\n').mid(2)) {
            const QStringList words = text.trimmed().split(QRegularExpression(QStringLiteral(" {2,}")));
            for (const QString& word : words.size() > 1 ? words : QStringList()) {
                QVERIFY2(page.cells.contains(word), qPrintable(text));
            }
            rows += words.size() > 1 ? 1 : 0;
        }
    }
    QVERIFY2(rows >= 1, qPrintable(run.out));
    QCOMPARE(page.rows, rows + static_cast<int>(json["header"].toObject().size()));

    QProcess python;
    python.setProcessChannelMode(QProcess::MergedChannels);
    python.start(
        QStringLiteral("python3"),
        {"-c",
         "import json, sys\ntry:\n    import jsonschema\nexcept ImportError:\n    sys.exit(77)\n"
         "jsonschema.validate(json.load(open(sys.argv[1])), json.load(open(sys.argv[2])))",
         in("r.json"),
         QStringLiteral(HITSCOPE_SHADERS "/../resources/schemas/cli/bench-%1.schema.json").arg(name)});
    QVERIFY(python.waitForFinished(60'000));
    if (python.exitCode() == 77) {
        QSKIP("Python's package jsonschema is not here.");
    }
    QVERIFY2(python.exitCode() == 0, python.readAll().right(2000).constData());
}

// With five runs of each the interval of 99 % goes from the least quotient to the greatest.
void BenchReportsTest::knownRatios() {
    writeBytes(in("a.json"), reportOf({{"double", "[10, 11, 12, 13, 14]"},
                                       {"half", "[10, 11, 12, 13, 14]"},
                                       {"same", "[10, 11, 12, 13, 14]"},
                                       {"few", "[1, 1.5, 2]"},
                                       {"a little", "[1, 1.001, 1.002, 1.003, 1.004]"},
                                       {"gone", "[1]"}}));
    writeBytes(in("b.json"), reportOf({{"few", "[8, 9, 10]"},
                                       {"double", "[28, 26, 24, 22, 20]"},
                                       {"half", "[5, 5.5, 6, 6.5, 7]"},
                                       {"same", "[12, 11, 14, 10, 13]"},
                                       {"a little", "[1.03, 1.031, 1.032, 1.033, 1.034]"},
                                       {"new", "[1]"}}));
    const QJsonObject rows = compared({}, 1);
    QCOMPARE(rows.size(), 5);
    const auto check = [&rows](const char* name, double ratio, double low, double high, const char* verdict) {
        const QJsonObject row = rows[QStringLiteral("hits 7, ") + QLatin1String(name)].toObject();
        QCOMPARE(row["ratio"].toDouble(), ratio);
        QCOMPARE(row["ratio_low"].toDouble(), low);
        QCOMPARE(row["ratio_high"].toDouble(), high);
        QCOMPARE(row["verdict"].toString(), QLatin1String(verdict));
    };
    check("double", 2.0, 20.0 / 14.0, 2.8, "slower");
    check("half", 0.5, 5.0 / 14.0, 0.7, "faster");
    check("same", 1.0, 10.0 / 14.0, 1.4, "no difference seen");
    check("a little", 1.032 / 1.002, 1.03 / 1.004, 1.034, "slower, in tolerance");
    QVERIFY(rows[QStringLiteral("hits 7, few")].toObject()["ratio_low"].isNull());
    QCOMPARE(rows[QStringLiteral("hits 7, few")].toObject()["verdict"].toString(),
             QStringLiteral("too few runs"));

    const CliRun text = runCli({"bench", "compare", in("a.json"), in("b.json")});
    QCOMPARE(text.status, 1);
    QVERIFY2(text.out.contains("Only A has the row: hits 7, gone") &&
                 text.out.contains("Only B has the row: hits 7, new"),
             qPrintable(text.out));
    QVERIFY2(text.err.contains("1 row is slower by more than the tolerance"), qPrintable(text.err));
}

// For six and six runs the tables of Mann and Whitney's U give 5 as the greatest value that is certain to
// 95 %, and for eight and ten 17: as many quotients and one more lie outside at either end.
void BenchReportsTest::orderStatistics() {
    const auto interval = [this](const std::vector<double>& a, const std::vector<double>& b,
                                 std::size_t outside) {
        const auto json = [](const std::vector<double>& values) {
            QByteArray text;
            for (const double value : values) {
                text += (text.isEmpty() ? "[" : ", ") + QByteArray::number(value, 'g', 17);
            }
            return text + "]";
        };
        writeBytes(in("a.json"), reportOf({{"x", json(a)}}));
        writeBytes(in("b.json"), reportOf({{"x", json(b)}}));
        std::vector<double> quotients;
        for (const double over : b) {
            for (const double under : a) {
                quotients.push_back(over / under);
            }
        }
        std::sort(quotients.begin(), quotients.end());
        const QJsonObject row =
            compared({"--confidence", "0.95", "--tolerance", "50"}, 0)["hits 7, x"].toObject();
        QCOMPARE(row["ratio_low"].toDouble(), quotients[outside]);
        QCOMPARE(row["ratio_high"].toDouble(), quotients[quotients.size() - 1 - outside]);
    };
    interval({3.1, 2.7, 5.2, 4.4, 3.9, 2.2}, {4.6, 6.1, 5.7, 3.3, 7.9, 8.8}, 5);
    interval({1.3, 1.9, 1.1, 2.3, 1.7, 1.4, 2.9, 3.1}, {2.1, 3.7, 1.6, 4.1, 4.3, 4.7, 5.3, 5.9, 6.1, 6.7},
             17);
}

void BenchReportsTest::toleranceDecides() {
    writeBytes(in("a.json"), reportOf({{"x", "[10, 10.1, 10.2, 10.3, 10.4]"}}));
    writeBytes(in("b.json"), reportOf({{"x", "[11, 11.1, 11.2, 11.3, 11.4]"}}));  // 11 / 10.4 is 1.0577
    QVERIFY(!compared({"--tolerance", "0.057"}, 1).isEmpty());
    QVERIFY(!compared({"--tolerance", "0.058"}, 0).isEmpty());
    QVERIFY(!compared({"--confidence", "0.999"}, 0).isEmpty());  // five runs cannot tell that
}

void BenchReportsTest::badReports_data() {
    QTest::addColumn<QByteArray>("b");
    QTest::addColumn<QString>("says");
    QTest::newRow("no JSON") << QByteArray("{\"report\": ") << "not JSON";
    QTest::newRow("empty") << QByteArray() << "not JSON";
    QTest::newRow("other JSON") << QByteArray("[1, 2]") << "not the report of a benchmark";
    QTest::newRow("other report") << QByteArray("{\"report\": \"info\"}") << "not the report of a benchmark";
    QTest::newRow("another benchmark") << reportOf({{"x", "[1]"}}, "io") << "bench io";
    QTest::newRow("no rows") << reportOf({}) << "no runs";
    QTest::newRow("no runs") << reportOf({{"x", "[]"}}) << "no runs";
    QTest::newRow("zero") << reportOf({{"x", "[1, 0]"}}) << "\"hits 7, x\" is no number above 0";
    QTest::newRow("text") << reportOf({{"x", "[\"fast\"]"}}) << "no number above 0";
    QTest::newRow("twice") << reportOf({{"x", "[1]"}, {"x", "[1]"}}) << "Two rows";
    QTest::newRow("no common row") << reportOf({{"y", "[1]"}}) << "no row in common";
}

void BenchReportsTest::badReports() {
    QFETCH(QByteArray, b);
    QFETCH(QString, says);
    writeBytes(in("a.json"), reportOf({{"x", "[1]"}}));
    writeBytes(in("b.json"), b);
    const CliRun run = runCli({"bench", "compare", in("a.json"), in("b.json")});
    QCOMPARE(run.status, 3);
    QVERIFY2(run.err.contains(in("b.json")) && run.err.contains(says), qPrintable(run.err));
    QCOMPARE(run.err.count(u'\n'), 1);
    QVERIFY(run.out.isEmpty());
}

HITSCOPE_TEST(BenchReportsTest, QCoreApplication)

}  // namespace hitscope::bench_reports_test

#include "bench_reports_test.moc"
