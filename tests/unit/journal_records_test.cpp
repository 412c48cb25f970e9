// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QTest>
#include <random>

#include "deform/fingerprint.h"
#include "document/document_json.h"
#include "document/hit_pieces.h"
#include "document/journal_records.h"
#include "document_support.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::journal_records_test {

using namespace test;

namespace {

/// A journal, and what the session was after each of its lines.
struct Example {
    QByteArray bytes;
    std::vector<qsizetype> ends;     ///< of the lines
    std::vector<QByteArray> states;  ///< as files, after line i
};

class Writing {
public:
    explicit Writing(const SessionDocument& document) : m_document(document) {
        add(m_lines.begin(m_document));
    }
    void edit(std::size_t at, std::size_t remove, const std::vector<Hit>& insert) {
        auto& hits = m_document.hits;
        const auto from = hits.begin() + static_cast<std::ptrdiff_t>(at);
        hits.insert(hits.erase(from, from + static_cast<std::ptrdiff_t>(remove)), insert.begin(),
                    insert.end());
        m_document.positions.clear();  // of the hits before
        add(m_lines.edit(at, remove, insert));
    }
    void set(const std::vector<Section>& sections) { add(m_lines.set(sections, m_document)); }
    SessionDocument& document() { return m_document; }
    const Example& example() const { return m_example; }

private:
    void add(const std::string& text) {
        m_example.bytes += QByteArray::fromStdString(text);
        m_example.ends.push_back(m_example.bytes.size());
        m_example.states.push_back(writeDocument(m_document));
    }

    JournalLines m_lines;
    SessionDocument m_document;
    Example m_example;
};

Example smallJournal() {
    SessionDocument start = exampleDocument();
    start.selection = {};
    Writing writing(start);
    writing.edit(3, 0, {exampleHit(3, 1.0f), exampleHit(1, -0.0f)});
    writing.document().lights.spot.innerAngle = 0.1f;
    writing.document().scene.name = QStringLiteral("Other\nname");
    writing.set({Section::Lights, Section::Scene});
    writing.edit(0, 2, {});
    writing.edit(1, 1, {exampleHit(1, 9.0f)});
    writing.edit(1, 2, {});
    writing.document().targets.resize(2);
    writing.document().positions.clear();
    writing.set({Section::Targets, Section::Positions});
    return writing.example();
}

/// With the right checksum, whatever it says.
QByteArray lineOf(std::uint64_t number, const QByteArray& json) {
    Fingerprint print;
    print.add(number);
    for (const char c : json) {
        print.add(static_cast<std::uint8_t>(c));
    }
    return QByteArray::fromStdString(fingerprintText(print.value())) + ' ' + json + '\n';
}

}  // namespace

class JournalRecordsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void allOfItComesBack();
    void everySection();
    void someOfTheTargets();
    void pictures();
    void cutAnywhere();
    void damagedAnywhere();
    void linesOutOfPlace();
    void badLines_data();
    void badLines();
    void badBegins_data();
    void badBegins();
    void mutations();
    void danglingThings();
    void manyEdits();
};

void JournalRecordsTest::allOfItComesBack() {
    const Example example = smallJournal();
    const Result<RecoveredJournal> read = readJournal(example.bytes);
    QVERIFY2(read.ok(), qPrintable(messageOf(read)));
    QCOMPARE(writeDocument(read.value().document), example.states.back());
    QCOMPARE(read.value().edits, std::size_t(4));
    QCOMPARE(read.value().settings, std::size_t(2));
    QCOMPARE(read.value().goodBytes, static_cast<std::size_t>(example.bytes.size()));
    QCOMPARE(read.value().droppedHits, std::size_t(0));
    QVERIFY2(read.value().problem.empty(), read.value().problem.c_str());
    QCOMPARE(example.bytes.count('\n'), 8);
}

/// Each is replaced as a whole, alone, by what it is now.
void JournalRecordsTest::everySection() {
    SessionDocument before;
    before.targets = exampleDocument().targets;
    SessionDocument after = exampleDocument();
    after.constants.constants.power = 0.01f;
    after.projectile.mass = 5.0f;
    after.simulation.paused = true;
    after.lights.directional.on = false;
    after.display.flat = true;
    after.selection.hit.reset();
    after.selection.shown.reset();
    after.targets[0].visible = false;
    for (std::size_t i = 0; i + 1 < kSections.size(); ++i) {
        const auto section = static_cast<Section>(i);
        JournalLines lines;
        std::string text = lines.begin(before);
        text += lines.set({&section, 1}, after);
        const Result<RecoveredJournal> read = readJournal(QByteArray::fromStdString(text));
        QVERIFY2(read.ok() && read.value().problem.empty(), kSections[i].data());
        const QByteArray written = writeDocument(read.value().document);
        QVERIFY2(written != writeDocument(before), kSections[i].data());
        // And back again.
        text += lines.set({&section, 1}, before);
        const Result<RecoveredJournal> back = readJournal(QByteArray::fromStdString(text));
        QVERIFY2(back.ok() && writeDocument(back.value().document) == writeDocument(before),
                 kSections[i].data());
    }
}

void JournalRecordsTest::someOfTheTargets() {
    const SessionDocument before = exampleDocument();
    SessionDocument after = before;
    after.targets[1].transform.position.x = 7.0f;
    after.positions.clear();  // they would be those of other targets, for all the line says
    SessionDocument part;
    part.targets = {after.targets[1]};
    JournalLines lines;
    QByteArray text = QByteArray::fromStdString(lines.begin(before));
    text += QByteArray::fromStdString(lines.someTargets(part));
    const Result<RecoveredJournal> read = readJournal(text);
    QVERIFY2(read.ok() && read.value().problem.empty(), qPrintable(messageOf(read)));
    QCOMPARE(writeDocument(read.value().document), writeDocument(after));
    QCOMPARE(read.value().settings, std::size_t(1));
}

/// The last counts; one that is none of ours ends what is good.
void JournalRecordsTest::pictures() {
    JournalLines lines;
    const QByteArray first("\xff\xd8 first\0picture", 16);
    const QByteArray second(static_cast<qsizetype>(kMostPicture), '\xfe');
    QByteArray bytes = QByteArray::fromStdString(lines.begin(exampleDocument()));
    bytes += QByteArray::fromStdString(lines.picture(first));
    QCOMPARE(readJournal(bytes).value().picture, first);
    bytes += QByteArray::fromStdString(lines.edit(0, 1, {}));
    bytes += QByteArray::fromStdString(lines.picture(second));
    const Result<RecoveredJournal> read = readJournal(bytes);
    QVERIFY2(read.ok(), qPrintable(messageOf(read)));
    QCOMPARE(read.value().picture, second);
    QCOMPARE(read.value().edits, std::size_t(1));
    QVERIFY(read.value().problem.empty());
    const QByteArray tooLarge = bytes + QByteArray::fromStdString(lines.picture(second + 'x'));
    QCOMPARE(readJournal(tooLarge).value().picture, second);
    QVERIFY(!readJournal(tooLarge).value().problem.empty());
    const QByteArray noBase64 = bytes + lineOf(5, R"({"picture":"a*b"})");
    QVERIFY(!readJournal(noBase64).value().problem.empty());
}

void JournalRecordsTest::cutAnywhere() {
    const Example example = smallJournal();
    for (qsizetype size = 0; size < example.bytes.size(); ++size) {
        const Result<RecoveredJournal> read = readJournal(example.bytes.left(size));
        const auto whole = static_cast<std::size_t>(
            std::upper_bound(example.ends.begin(), example.ends.end(), size) - example.ends.begin());
        if (whole == 0) {
            QVERIFY2(!read.ok(), qPrintable(QString::number(size)));
            QVERIFY(messageOf(read).contains(QStringLiteral("Nothing can be recovered from this journal.")));
            continue;
        }
        QVERIFY2(read.ok(), qPrintable(messageOf(read)));
        const bool isCut = example.ends[whole - 1] != size;
        QCOMPARE(read.value().problem.empty(), !isCut);
        QCOMPARE(read.value().lostLines, std::size_t{0});  // a line that is cut was never whole
        QCOMPARE(read.value().goodBytes, static_cast<std::size_t>(example.ends[whole - 1]));
        QCOMPARE(writeDocument(read.value().document), example.states[whole - 1]);
    }
}

void JournalRecordsTest::damagedAnywhere() {
    const Example example = smallJournal();
    for (qsizetype at = 0; at < example.bytes.size(); ++at) {
        QByteArray bytes = example.bytes;
        bytes[at] = static_cast<char>(bytes[at] ^ 1);
        const Result<RecoveredJournal> read = readJournal(bytes);
        const auto whole = static_cast<std::size_t>(
            std::upper_bound(example.ends.begin(), example.ends.end(), at) - example.ends.begin());
        QCOMPARE(read.ok(), whole > 0);
        if (read) {
            QVERIFY(!read.value().problem.empty());
            QCOMPARE(writeDocument(read.value().document), example.states[whole - 1]);
            const std::size_t ends = example.bytes[at] == '\n' ? 1 : 0;  // two lines became one
            QCOMPARE(read.value().lostLines, example.ends.size() - whole - ends);
        }
    }
}

void JournalRecordsTest::linesOutOfPlace() {
    const QList<QByteArray> lines = smallJournal().bytes.split('\n');
    const auto joined = [&lines](const QList<int>& order) {
        QByteArray bytes;
        for (const int line : order) {
            bytes += lines[line] + '\n';
        }
        return readJournal(bytes);
    };
    QCOMPARE(joined({0, 1, 2, 3}).value().edits, std::size_t(1));
    QCOMPARE(joined({0, 1, 2, 2}).value().edits, std::size_t(1));
    QCOMPARE(joined({0, 1, 3, 2}).value().settings, std::size_t(0));
    QCOMPARE(joined({0, 1, 3}).value().settings, std::size_t(0));
    QVERIFY(!joined({1, 0}).ok());
}

void JournalRecordsTest::badLines_data() {
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("problem");
    const auto row = [](const char* title, const QByteArray& json, const char* problem) {
        QTest::newRow(title) << json << problem;
    };
    row("no JSON", "{\"hits\":", "It ends in the middle.");
    row("nothing", "{}", "A line changes nothing that is known.");
    row("list", "[]", "It has to be an object");
    row("no place", "{\"hits\":{\"remove\":1}}", "It is missing.");
    row("beyond", "{\"hits\":{\"at\":4,\"remove\":0,\"insert\":[]}}",
        "A line edits hits that are not there.");
    row("too many", "{\"hits\":{\"at\":1,\"remove\":3,\"insert\":[]}}",
        "A line edits hits that are not there.");
    row("far too many", "{\"hits\":{\"at\":1,\"remove\":18446744073709551615}}", "A line edits hits that");
    row("bad hit",
        "{\"hits\":{\"at\":1,\"insert\":[{\"target\":1,\"point\":[0,0,0],\"direction\":[0,0,0]}]}}",
        "The hit has no direction");
    row("bad section", "{\"set\":{\"lights\":{\"spot\":{\"on\":3}}}}", "It has to be true or false.");
    row("same ids",
        "{\"set\":{\"targets\":[{\"id\":1,\"source\":{\"kind\":\"unknown\"}},"
        "{\"id\":1,\"source\":{\"kind\":\"unknown\"}}]}}",
        "Another target has the id 1 too.");
    row("some that are none", "{\"some\":{\"targets\":[{\"id\":99,\"source\":{\"kind\":\"unknown\"}}]}}",
        "A line changes a target that is not there.");
    row("second change is bad", "{\"set\":{\"scene\":{\"name\":\"X\"},\"lights\":3}}",
        "It has to be an object");
}

/// The line changes nothing at all, and nothing behind it counts.
void JournalRecordsTest::badLines() {
    QFETCH(QByteArray, json);
    QFETCH(QString, problem);
    JournalLines lines;
    const QByteArray begin = QByteArray::fromStdString(lines.begin(exampleDocument()));
    const Result<RecoveredJournal> read =
        readJournal(begin + lineOf(2, json) + lineOf(3, "{\"hits\":{\"at\":0,\"remove\":1}}"));
    QVERIFY2(read.ok(), qPrintable(messageOf(read)));
    QVERIFY2(QString::fromStdString(read.value().problem).contains(problem), read.value().problem.c_str());
    QCOMPARE(read.value().goodBytes, static_cast<std::size_t>(begin.size()));
    QCOMPARE(writeDocument(read.value().document), writeDocument(exampleDocument()));
}

void JournalRecordsTest::badBegins_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("message");
    const QByteArray head = lineOf(0, "{\"format\":\"hitscope journal\",\"version\":1}");
    QTest::newRow("empty") << QByteArray() << "It ends in the middle of a line. line 1";
    QTest::newRow("text") << QByteArray("Dear reader,\n") << "A line has no checksum.";
    QTest::newRow("session") << writeDocument(exampleDocument()) << "A line has no checksum.";
    QTest::newRow("binary") << QByteArray(5000, '\0') << "It ends in the middle of a line.";
    QTest::newRow("lines") << QByteArray(5000, '\n') << "A line has no checksum.";
    QTest::newRow("other") << lineOf(0, "{\"format\":\"x\",\"version\":1}")
                           << "This is no journal of Hitscope.";
    QTest::newRow("newer") << lineOf(0, "{\"format\":\"hitscope journal\",\"version\":5}")
                           << "This journal was written by a newer Hitscope. Recover it with that Hitscope";
    QTest::newRow("head alone") << head << "It ends in the middle of a line.";
    QTest::newRow("no session") << head + lineOf(1, "{}") << "This is no session of Hitscope.";
    QTest::newRow("deep") << head + lineOf(1, QByteArray(100'000, '[')) << "more than 64 brackets";
}

void JournalRecordsTest::badBegins() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, message);
    const Result<RecoveredJournal> read = readJournal(bytes);
    QVERIFY(!read.ok());
    const QString said = messageOf(read);
    QVERIFY2(said.contains(message.section(QStringLiteral(" line 1"), 0, 0)), qPrintable(said));
    QVERIFY(!read.error().advice.empty());
}

/// Bytes are changed, and checksums mended so that the change is looked at.
void JournalRecordsTest::mutations() {
    const QList<QByteArray> original = smallJournal().bytes.split('\n');
    std::mt19937 random(7);
    const auto upTo = [&random](qsizetype most) {
        return std::uniform_int_distribution<qsizetype>(0, most)(random);
    };
    for (int i = 0; i < 4000; ++i) {
        QByteArray bytes;
        for (qsizetype line = 0; line + 1 < original.size(); ++line) {
            QByteArray json = original[line].mid(17);
            if (upTo(3) == 0) {
                const qsizetype at = upTo(json.size() - 1);
                const char digit = static_cast<char>('0' + upTo(9));
                json[at] = json[at] >= '0' && json[at] <= '9' ? digit : static_cast<char>(32 + upTo(94));
            }
            bytes += lineOf(static_cast<std::uint64_t>(line), json);
        }
        const Result<RecoveredJournal> read = readJournal(bytes);
        if (read) {
            const QByteArray written = writeDocument(read.value().document);
            const Result<SessionDocument> again = readDocument(written);
            QVERIFY2(again.ok(), qPrintable(messageOf(again)));
            QCOMPARE(writeDocument(again.value()), written);
        } else {
            QVERIFY(!read.error().what.empty());
        }
    }
}

/// What is recovered is fit to be saved and opened.
void JournalRecordsTest::danglingThings() {
    SessionDocument document = exampleDocument();
    JournalLines lines;
    std::string text = lines.begin(document);
    text += lines.edit(0, 1, {});
    document.targets.erase(document.targets.begin() + 1);  // with its hits still there
    const Section section = Section::Targets;
    text += lines.set({&section, 1}, document);
    const Result<RecoveredJournal> read = readJournal(QByteArray::fromStdString(text));
    QVERIFY(read.ok());
    QVERIFY(read.value().problem.empty());
    QCOMPARE(read.value().droppedHits, std::size_t(1));
    QCOMPARE(read.value().document.hits.size(), std::size_t(1));
    QVERIFY(readDocument(writeDocument(read.value().document)).ok());
}

/// A long list takes edits anywhere as a vector does, and fast.
void JournalRecordsTest::manyEdits() {
    std::mt19937 random(3);
    const auto upTo = [&random](std::size_t most) {
        return std::uniform_int_distribution<std::size_t>(0, most)(random);
    };
    std::vector<Hit> plain;
    HitPieces pieces({});
    for (int i = 0; i < 3000; ++i) {
        const std::size_t at = upTo(plain.size());
        const std::size_t remove = std::min(plain.size() - at, upTo(i % 50 == 0 ? 3000 : 20));
        std::vector<Hit> insert(upTo(i % 70 == 0 ? 5000 : 20), exampleHit(1, static_cast<float>(i)));
        const auto from = plain.begin() + static_cast<std::ptrdiff_t>(at);
        plain.insert(plain.erase(from, from + static_cast<std::ptrdiff_t>(remove)), insert.begin(),
                     insert.end());
        pieces.splice(at, remove, insert);
        QCOMPARE(pieces.size(), plain.size());
    }
    QVERIFY(plain.size() > 5000);
    QVERIFY(pieces.take() == plain);
    QCOMPARE(pieces.size(), std::size_t(0));

    // Each edit in its own time: moving half a million hits 4,000 times takes minutes.
    HitPieces many(std::vector<Hit>(500'000, exampleHit(1, 0.0f)));
    const Hit hit = exampleHit(1, 1.0f);
    QElapsedTimer timer;
    timer.start();
    for (int i = 0; i < 2'000; ++i) {
        many.splice(0, 1, {});
        many.splice(many.size() / 2, 0, {&hit, 1});
    }
    QVERIFY2(timer.elapsed() < 60'000, qPrintable(QString::number(timer.elapsed())));
}

HITSCOPE_TEST(JournalRecordsTest, QCoreApplication)

}  // namespace hitscope::journal_records_test

#include "journal_records_test.moc"
