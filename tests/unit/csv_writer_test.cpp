// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/csv_writer.h"

#include <QTest>
#include <limits>

#include "support/test_program.h"

namespace hitscope::csv_writer_test {

class CsvWriterTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void quotesWhatNeedsIt() {
        CsvWriter csv;
        csv.comment("made by a test");
        csv.row({"plain", "a b", ""});
        csv.row({"1,2", "say \"hit\"", "two\nlines"});
        csv.quoted("plain").empty().text("cr\rhere");
        csv.endRow();
        QCOMPARE(csv.written(), std::string("# made by a test\n"
                                            "plain,a b,\n"
                                            "\"1,2\",\"say \"\"hit\"\"\",\"two\nlines\"\n"
                                            "\"plain\",,\"cr\rhere\"\n"));
        QCOMPARE(csv.take().size(), std::size_t{79});
        csv.row({"new"});
        QCOMPARE(csv.take(), std::string("new\n"));
    }

    void endsLinesAsAsked() {
        CsvWriter csv(CsvWriter::LineEnd::CrLf);
        csv.row({"a", "b"});
        csv.count(12).exact(0.1f);
        csv.endRow();
        QCOMPARE(csv.take(), std::string("a,b\r\n12,0.1\r\n"));
    }

    void writesNumbersForPrograms() {
        CsvWriter csv;
        csv.count(std::numeric_limits<std::uint64_t>::max()).exact(0.1f).exact(0.1).exact(-0.0f);
        csv.general(1.0 / 3.0, 9).general(1.0e-5, 9).general(std::nullopt, 9).fixed(2.5, 6);
        csv.endRow();
        QCOMPARE(csv.take(), std::string("18446744073709551615,0.1,0.1,-0,0.333333333,1e-05,,2.500000\n"));
        csv.fixed(-std::numeric_limits<double>::max(), 6);
        QCOMPARE(csv.take().size(), std::size_t{317});
    }
};

HITSCOPE_TEST(CsvWriterTest, QCoreApplication)

}  // namespace hitscope::csv_writer_test

#include "csv_writer_test.moc"
