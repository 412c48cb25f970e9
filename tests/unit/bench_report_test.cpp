// SPDX-License-Identifier: GPL-3.0-or-later
// What a benchmark writes, and what it measures on.
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

#include "cli/bench/paper_figures.h"
#include "cli/bench/report.h"
#include "cli/bench/sphere.h"
#include "cli/bench/texture.h"
#include "mesh/panel_texture.h"
#include "support/test_program.h"

namespace hitscope::bench_report_test {

using namespace bench;

namespace {

Report smallReport() {
    Report report;
    report.benchmark = QStringLiteral("small");
    report.header = {{QStringLiteral("renderer"), QStringLiteral("pencil")}};
    report.tables = {{QStringLiteral("A table"),
                      {QStringLiteral("name"), QStringLiteral("value")},
                      {{QStringLiteral("one"), QStringLiteral("1")}, {QStringLiteral("long name")}},
                      {QStringLiteral("below")}}};
    report.fields = {QStringLiteral("name"), QStringLiteral("value")};
    report.records = {
        {{QStringLiteral("name"), QStringLiteral("a, \"b\"")}, {QStringLiteral("value"), 0.5}},
        {{QStringLiteral("name"), QStringLiteral("c")}, {QStringLiteral("value"), QJsonValue()}}};
    report.notes = {QStringLiteral("A note.")};
    return report;
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class BenchReportTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void textHasColumns() {
        QCOMPARE(toText(smallReport()), QStringLiteral("renderer: pencil\n"
                                                       "\n"
                                                       "A table\n"
                                                       "name       value\n"
                                                       "one            1\n"
                                                       "long name\n"
                                                       "  below\n"
                                                       "\n"
                                                       "A note.\n"));
    }

    void paperRatiosHaveTheirRange() {
        QCOMPARE(paperRatio("60", "20"), QStringLiteral("x3.00"));
        QCOMPARE(paperRatio("170-270", "15"), QStringLiteral("x11.3-18.0"));
        QCOMPARE(paperRatio("150-760", "200-350"), QStringLiteral("x0.429-3.80"));
        QCOMPARE(paperTable1().size(), paperTable2().size());
    }

    void jsonHasAll() {
        Report report = smallReport();
        report.records[0].insert(QStringLiteral("runs"), QJsonArray{0.1, 1.0 / 3.0});
        const QByteArray text = toJson(report);
        QVERIFY2(text.startsWith("{\n  \"report\": \"bench small\",\n"), text.constData());
        const QJsonObject json = QJsonDocument::fromJson(text).object();
        const QJsonArray runs =
            json[QStringLiteral("records")].toArray()[0].toObject()[QStringLiteral("runs")].toArray();
        QCOMPARE(runs, (QJsonArray{0.1, 1.0 / 3.0}));  // the same bits
        QCOMPARE(json[QStringLiteral("header")].toObject()[QStringLiteral("renderer")].toString(),
                 QStringLiteral("pencil"));
        const QJsonArray records = json[QStringLiteral("records")].toArray();
        QCOMPARE(records.size(), 2);
        QCOMPARE(records[0].toObject()[QStringLiteral("value")].toDouble(), 0.5);
        QVERIFY(records[1].toObject()[QStringLiteral("value")].isNull());
    }

    void csvQuotes() {
        QCOMPARE(toCsv(smallReport()), QByteArray("# benchmark: small\n# renderer: pencil\n# A note.\n"
                                                  "name,value\n\"a, \"\"b\"\"\",0.5\nc,\n"));
    }

    void filesAreWritten() {
        const QTemporaryDir folder;
        const Destinations destinations{.report = folder.filePath(QStringLiteral("r.json")),
                                        .csv = folder.filePath(QStringLiteral("r.csv")),
                                        .quiet = true};
        QVERIFY(checkDestinations(destinations));
        QVERIFY(!QFile::exists(destinations.report));
        QVERIFY(writeReport(smallReport(), destinations));
        QCOMPARE(contents(destinations.report), toJson(smallReport()));
        QCOMPARE(contents(destinations.csv), toCsv(smallReport()));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 2);
    }

    void tablesGiveWayToData() {
        const QString file = QStringLiteral("r");
        const QString out = QStringLiteral("-");
        QVERIFY(Destinations().wantsText());
        QVERIFY(Destinations{.quiet = true}.wantsText());
        QVERIFY((Destinations{.report = file, .csv = file}.wantsText()));
        QVERIFY((!Destinations{.report = file, .quiet = true}.wantsText()));
        QVERIFY(!Destinations{.json = true}.wantsText());
        QVERIFY((!Destinations{.report = file, .csv = out}.wantsText()));
        QCOMPARE((Destinations{.json = true, .report = out, .csv = out}.toStandardOutput()), 3);
    }

    void destinationsAreCheckedFirst() {
        const QTemporaryDir folder;
        const Destinations missing{.report = folder.filePath(QStringLiteral("no/r.json"))};
        QVERIFY(!checkDestinations({.csv = folder.path()}));
        QVERIFY(checkDestinations({.report = QStringLiteral("-")}));
        const Status status = checkDestinations(missing);
        QVERIFY(!status && status.error().message().find("r.json") != std::string::npos);
    }

    void numbersAreShort() {
        QCOMPARE(shortNumber(0.0), QStringLiteral("0"));
        QCOMPARE(shortNumber(1234.2), QStringLiteral("1234"));
        QCOMPARE(shortNumber(12.345), QStringLiteral("12.3"));
        QCOMPARE(shortNumber(0.012345), QStringLiteral("0.0123"));
        QCOMPARE(shortTime(0.00000123), QStringLiteral("1.23 µs"));
        QCOMPARE(shortTime(0.0123), QStringLiteral("12.3 ms"));
        QCOMPARE(shortTime(12.3), QStringLiteral("12.3 s"));
        QCOMPARE(grouped(7), QStringLiteral("7"));
        QCOMPARE(grouped(1000000), QStringLiteral("1,000,000"));
    }

    void paperTablesAreComplete() {
        QCOMPARE(paperTable1().size(), std::size_t{9});
        QCOMPARE(paperTable2().size(), std::size_t{9});
        QCOMPARE(QLatin1String(paperTable1()[5].l2), QLatin1String("200-350"));
        QCOMPARE(QLatin1String(paperTable2()[8].l1), QLatin1String("140-310"));
    }

    void texturedMeshIsValid() {
        MeshData mesh = makeSphere(200);
        useTexture(mesh);
        QVERIFY(validate(mesh));
        QVERIFY(!mesh.cornerTexcoords.empty());
        const MeshData carrier = textureCarrier(makePanelTexture(16));
        QVERIFY(validate(carrier));
        QCOMPARE(carrier.materials.front().diffuseImage, 0);
    }

    void spheresHaveTheSizeAskedFor() {
        QCOMPARE(makeSphere(7938).positions.size(), std::size_t{7938});
        QCOMPARE(makeSphere(8000).positions.size(), std::size_t{7938});
        for (const int wanted : {8, 1000, 100000}) {
            const auto made = static_cast<double>(makeSphere(wanted).positions.size());
            QVERIFY2(std::abs(made - wanted) <= 0.05 * wanted + 4.0, qPrintable(QString::number(made)));
        }
    }
};

HITSCOPE_TEST(BenchReportTest, QCoreApplication)

}  // namespace hitscope::bench_report_test

#include "bench_report_test.moc"
