// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QTest>
#include <functional>
#include <random>

#include "document/document_json.h"
#include "document/json_text.h"
#include "document_support.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::document_bad_input_test {

using namespace test;

namespace {

const QByteArray& good() {
    static const QByteArray bytes = writeDocument(exampleDocument());
    return bytes;
}

/// The good file with one place of it changed.
QByteArray with(const char* before, const char* after) {
    const qsizetype at = good().indexOf(before);
    if (at < 0) {
        qFatal("%s is not in the file", before);
    }
    QByteArray bytes = good();
    return bytes.replace(at, static_cast<qsizetype>(qstrlen(before)), after);
}

QByteArray head(const QByteArray& rest) {
    return "{\"format\": \"hitscope session\", \"version\": 1" + rest + "}";
}

/// Changes, removes or repeats a few pieces of a file, as a broken disk or a hostile person would.
QByteArray mutated(QByteArray bytes, std::mt19937& random) {
    static const QByteArray kPieces[] = {"-1",    "99999999999999999999",
                                         "nan",   "\n",
                                         "[",     "]",
                                         "{",     "}",
                                         "\"",    ",",
                                         ":",     "-0",
                                         "1e999", "\\",
                                         "0",     "null",
                                         "\xff",  "\\ud800"};
    const auto upTo = [&random](qsizetype most) {
        return std::uniform_int_distribution<qsizetype>(0, most)(random);
    };
    for (qsizetype change = upTo(4) + 1; change > 0; --change) {
        const qsizetype at = upTo(bytes.size());
        switch (upTo(5)) {
            case 0:
                if (at < bytes.size()) {
                    bytes[at] = static_cast<char>(upTo(255));
                }
                break;
            case 1:
                bytes.remove(at, upTo(20));
                break;
            case 2:
                bytes.insert(at, kPieces[upTo(std::size(kPieces) - 1)]);
                break;
            case 3:
                bytes.insert(at, bytes.mid(upTo(bytes.size()), upTo(60)));
                break;
            case 4:
                // A digit for another: most such files stay JSON.
                for (qsizetype i = at; i < bytes.size(); ++i) {
                    if (bytes[i] >= '0' && bytes[i] <= '9') {
                        bytes[i] = static_cast<char>('0' + upTo(9));
                        break;
                    }
                }
                break;
            default:
                if (upTo(20) == 0) {
                    bytes.truncate(at);
                }
        }
    }
    return bytes;
}

}  // namespace

/// Whatever a file holds, there is one message that says what is wrong, where, and what to do.
class DocumentBadInputTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void content_data();
    void content();
    void hits_data();
    void hits();
    void cutAnywhere();
    void mutations();
    void large();
    void texts();

private:
    void check(const QByteArray& bytes, const QString& message);
};

void DocumentBadInputTest::check(const QByteArray& bytes, const QString& message) {
    const Result<SessionDocument> result = readDocument(bytes);
    QVERIFY2(messageOf(result).contains(message), qPrintable(messageOf(result)));
    QVERIFY(!result.error().advice.empty());
    QVERIFY(!messageOf(result).contains(QLatin1Char('\n')));
    QVERIFY(QString::fromStdString(result.error().message()).size() < 500);
}

namespace {

using Row = std::function<void(const char* title, const QByteArray& bytes, const char* message)>;

// The rows, in parts that can be taken in at a glance.

void addForms(const Row& row) {
    row("empty", "", "The file is empty.");
    row("spaces", " \n\n", "The file is empty.");
    row("binary", QByteArray("\0\1\2\3", 4), "line 1: A value is neither number, text, list nor object.");
    row("text", "Dear reader,\n", "line 1: A value is neither");
    row("number", "12", "line 1: It has to be an object in braces.");
    row("list", "[1]", "line 1: It has to be an object in braces.");
    row("other JSON", "{\"a\": 1}", "line 1: This is no session of Hitscope. Choose a file");
    row("other format", "{\"format\": \"gltf\", \"version\": 1}", "This is no session of Hitscope.");
    row("format as number", "{\"format\": 1, \"version\": 1}", "line 1, format: It has to be a text.");
    row("no version", "{\"format\": \"hitscope session\"}", "Its version is missing.");
    row("version as text", with("\"version\": 1", "\"version\": \"1\""),
        "line 3, version: It has to be a number.");
    row("version 0", with("\"version\": 1", "\"version\": 0"), "version: It is 0, and has to be from 1");
    row("version 1.5", with("\"version\": 1", "\"version\": 1.5"), "version: It has to be a whole number.");
    row("newer version", with("\"version\": 1", "\"version\": 2"),
        "line 1: This session was saved by a newer Hitscope, in version 2 of the format. Open it with that "
        "Hitscope, or install the newest one.");
    row("much newer", with("\"version\": 1", "\"version\": 99999999999999999999"), "version: It is 9999");
    row("newer, not ours", "{\"format\": \"hitscope session\", \"version\": 7, \"hits\": 3}",
        "a newer Hitscope");
    row("two texts", good() + good(), "Something follows its end.");
    row("cut", good().left(good().size() / 2), "It ends in the middle.");
    row("no comma", with("\"version\": 1,", "\"version\": 1"),
        "line 4: A comma or a closing brace is missing.");
    row("no colon", with("\"version\": 1", "\"version\" 1"), "line 3: A colon is missing.");
    row("comma too many", "{\"format\": \"x\",}", "The name of a value is missing.");
    row("list with comma", head(", \"hits\": [1,]"), "A value is neither");
    row("NaN", with("\"floor_height\": -0.25", "\"floor_height\": NaN"), "line 6: A value is neither");
    row("infinite", with("\"floor_height\": -0.25", "\"floor_height\": 1e39"),
        "line 6, scene, floor_height: It is 1e39, which is too large or too small.");
    row("zero too many", with("\"floor_height\": -0.25", "\"floor_height\": -00.25"), "a zero too many");
    row("half a number", with("\"floor_height\": -0.25", "\"floor_height\": -0."),
        "line 6: A value is neither");
    row("no exponent", with("\"floor_height\": -0.25", "\"floor_height\": 1e"), "line 6: A value is neither");
    row("not UTF-8", with("Löwe", "L\xf6we"), "A text is not UTF-8.");
    row("overlong UTF-8", with("Löwe", "L\xc0\xafwe"), "A text is not UTF-8.");
    row("surrogates in UTF-8", with("Löwe", "L\xed\xa0\x80we"), "A text is not UTF-8.");
    row("beyond Unicode", with("Löwe", "L\xf4\x90\x80\x80we"), "A text is not UTF-8.");
    row("half a surrogate", with("Löwe", "L\\ud800we"), "A text has \\u without a character.");
    row("no code", with("Löwe", "L\\u12"), "A text has \\u without a character.");
    row("escape of nothing", with("Löwe", "L\\we"), "A text has a backslash that means nothing.");
    row("line in text", with("Löwe", "L\none"), "A text has a control character, or does not end.");
    row("long text", with("Löwe", QByteArray(20'000, 'x').constData()), "target 1, name: It is too long");
    row("deep", QByteArray(100'000, '['), "There are more than 64 brackets within each other.");
    row("deep object", QByteArray("{\"a\":").repeated(100'000), "There are more than 64 brackets");
    row("twice", with("\"name\": \"Löwe\"", "\"name\": \"a\", \"name\": \"b\""),
        "target 1, name: It is there twice.");
}

void addSections(const Row& row) {
    QByteArray many;
    for (int i = 0; i < 300; ++i) {
        many += ", \"k" + QByteArray::number(i) + "\": 0";
    }
    row("many values", head(many), "line 1: It has too many values.");

    row("section as list", with("\"lights\": {", "\"lights\": [], \"x\": {"),
        "lights: It has to be an object");
    row("list as object", with("\"hits\": [", "\"hits\": {}, \"x\": ["),
        "hits: It has to be a list in brackets.");
    row("null", with("\"lights\": {", "\"lights\": null, \"x\": {"), "lights: It has to be an object");
    row("target is text", head(", \"targets\": [\"a\"]"),
        "line 1, target 1: It has to be an object in braces.");
    row("no id", with("\"id\": 1", "\"ID\": 1"), "target 1, id: It is missing.");
    row("id 0", with("\"id\": 1", "\"id\": 0"), "target 1, id: It is 0, and has to be from 1");
    row("negative id", with("\"id\": 1", "\"id\": -1"), "target 1, id: It is -1");
    row("large id", with("\"id\": 1", "\"id\": 2147483648"), "target 1, id: It is 2147483648");
    row("same id", with("\"id\": 7", "\"id\": 1"), "target 2: Another target has the id 1 too.");
    row("no source", with("\"source\"", "\"Source\""), "target 1, source: It is missing.");
    row("strange source", with("\"kind\": \"file\"", "\"kind\": \"cloud\""),
        "target 1, source, kind: It has to be one of \"unknown\", \"primitive\", \"built-in\", \"file\".");
    row("no path", with("\"path\": \"/home", "\"Path\": \"/home"), "target 1, source, path: It is missing.");
    row("hash too short", with("aaaaaaaa", "aaaa"), "source, sha256: It has to be 64 hexadecimal digits");
    row("hash of letters", with("aaaaaaaa", "aaaxaaaa"),
        "source, sha256: It has to be 64 hexadecimal digits");
    row("too fine", with("\"resolution\": 60", "\"resolution\": 99999999"),
        "target 2, source, resolution: It is 99999999, and has to be from 9 to 1732.");
    row("no size", with("\"size\": 2.5", "\"size\": 0"), "target 2, source, size: It is 0");
    row("scale 0", with("\"scale\": 0.3333333333333333", "\"scale\": 0"), "placement, scale: It is 0");
    row("no rotation", with("\"rotation\": [0, 0.6, 0, 0.8]", "\"rotation\": [0, 0, 0, 0]"),
        "target 1, rotation: It is no rotation");
    row("long rotation", with("\"rotation\": [0, 0.6, 0, 0.8]", "\"rotation\": [0, 3e38, 0, 3e38]"),
        "target 1, rotation: It is no rotation");
    row("three numbers", with("\"rotation\": [0, 0.6, 0, 0.8]", "\"rotation\": [0, 0, 1]"),
        "rotation: It has to be a list of 4 numbers.");
    row("four numbers", with("\"position\": [0.1, 2, -3]", "\"position\": [0.1, 2, -3, 0]"),
        "target 1, position: It has to be a list of 3 numbers.");
    row("text as number", with("\"position\": [0.1, 2, -3]", "\"position\": [0.1, \"2\", -3]"),
        "target 1, position: It has to be a number.");
    row("number as flag", with("\"visible\": true", "\"visible\": 1"),
        "visible: It has to be true or false.");
    row("mass", with("\"mass\": 12", "\"mass\": 0"),
        "target 2, physics, mass: It is 0, and has to be from 0.001");
    row("constants", with("\"constants\": {", "\"constants\": {\"power\": -1, \"x\": {}}, \"y\": {"),
        "constants, power: It is -1, and has to be from 0 to 100.");
    row("speed", with("\"speed\": 30", "\"speed\": -30"), "projectile, speed: It is -30");
    row("colour", with("\"colour\": [0.9", "\"colour\": [1.9"), "projectile, colour: It is 1.9");
}

void addNumbers(const Row& row) {
    row("pipeline", with("\"pipeline\": \"transform-feedback\"", "\"pipeline\": \"magic\""),
        "simulation, pipeline: It has to be one of \"uniform-array\"");
    row("step", with("\"physics_step\": 0.004", "\"physics_step\": 4"), "simulation, physics_step: It is 4");
    row("angle", with("\"inner_angle\": 0.2", "\"inner_angle\": 7.2"),
        "lights, spot, inner_angle: It is 7.2");
    row("strength", with("\"diffuse\": 0.8", "\"diffuse\": -0.8"),
        "lights, directional, terms, diffuse: It is -0.8, "
        "and has to be from 0");
    row("camera", with("camera pivot", "camera pilot"),
        "cameras, current: It has a camera that cannot be read. \"pilot\" is no word of a camera.");
    row("range", with("\"low\": 0,", "\"low\": 1e9,"), "low: It has to be below the high end.");
    row("cut's normal", with("\"normal\": [1, 0, 0]", "\"normal\": [1, 1, 0]"),
        "display, cutting_plane, normal: It has to have the length 1.");
    row("exaggeration", with("\"exaggeration\": 1", "\"exaggeration\": 100"), "exaggeration: It is 100");
    row("selected target", with("\"selection\": {\n    \"target\": 7", "\"selection\": {\n    \"target\": 8"),
        "selection: It names target 8, which is not in the session.");
    row("selected hit", with("\"hit\": 1", "\"hit\": 3"),
        "selection: It names a hit beyond the 3 that there are.");
    row("shown hits", with("\"shown_hits\": 2", "\"shown_hits\": 4"),
        "selection: It names a hit beyond the 3");
    row("picked", with("\"picked\": {\n      \"target\": 1", "\"picked\": {\n      \"target\": 2"),
        "selection: It names target 2");
    row("vertices", with("{\"target\": 7, \"vertices\"", "{\"target\": 9, \"vertices\""),
        "It names target 9");
    row("vertices' order", with("[1, 2, 5]", "[1, 5, 2]"),
        "vertices: It has to have each number once, in asc");
    row("vertices twice", with("[1, 2, 5]", "[1, 1, 5]"), "vertices: It has to have each number once");
    row("fingerprint", with("0123456789abcdef", "0123456789abcdeg"),
        "position 1, fingerprint: It has to be 16 hex");
    row("position of nothing", with("{\"target\": 1, \"fingerprint\"", "{\"target\": 2, \"fingerprint\""),
        "position 1: It names target 2, which is not in the session.");
}

}  // namespace

void DocumentBadInputTest::content_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("message");
    const Row row = [](const char* title, const QByteArray& bytes, const char* message) {
        QTest::newRow(title) << bytes << message;
    };
    addForms(row);
    addSections(row);
    addNumbers(row);
}

void DocumentBadInputTest::content() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, message);
    check(bytes, message);
}

void DocumentBadInputTest::hits_data() {
    QTest::addColumn<QByteArray>("hit");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* title, const QByteArray& hit, const char* message) {
        QTest::newRow(title) << hit << message;
    };
    const QByteArray place = "\"target\": 1, \"point\": [0, 0, 0], ";
    const QByteArray whole = place + "\"direction\": [0, 0, 1], ";
    row("nothing", "", "target: It is missing.");
    row("no direction", place + "\"time\": 0", "direction: It is missing.");
    row("direction 0", place + "\"direction\": [0, 0, -0.0]", "It cannot be used. The hit has no direction");
    row("direction too large", place + "\"direction\": [0, 0, 1e39]", "direction: It is 1e39");
    row("missing target", "\"target\": 2, \"point\": [0, 0, 0], \"direction\": [0, 0, 1]",
        "It names target 2, which is not in the session.");
    row("no target", "\"target\": 0, \"point\": [0, 0, 0], \"direction\": [0, 0, 1]", "It names target 0");
    row("distance", whole + "\"max_distance\": -1", "It cannot be used. Max distance is -1");
    row("power", whole + "\"power\": 1e30", "It cannot be used. Power is 1e+30");
    row("time", whole + "\"time\": 1e999", "time: It is 1e999, which is too large or too small.");
    row("triangle", whole + "\"triangle\": 1.5", "triangle: It has to be a whole number.");
    row("pipeline", whole + "\"pipeline\": 256", "pipeline: It is 256");
    row("pipeline's name", whole + "\"pipeline\": \"paper\"", "pipeline: It has to be one of");
    row("flight", whole + "\"flight\": [0, 0]", "flight: It has to be a list of 3 numbers.");
    row("enabled", whole + "\"enabled\": \"yes\"", "enabled: It has to be true or false.");
}

void DocumentBadInputTest::hits() {
    QFETCH(QByteArray, hit);
    QFETCH(QString, message);
    const QByteArray fine = "{\"target\": 1, \"point\": [0, 0, 0], \"direction\": [0, 0, 1]},\n";
    check(head(",\n\"hits\": [" + fine.repeated(2) + "{" + hit +
               "}],\n"
               "\"targets\": [{\"id\": 1, \"source\": {\"kind\": \"unknown\"}}]"),
          "line 4, hit 3");
    check(head(",\n\"hits\": [" + fine.repeated(2) + "{" + hit +
               "}],\n"
               "\"targets\": [{\"id\": 1, \"source\": {\"kind\": \"unknown\"}}]"),
          message);
}

void DocumentBadInputTest::cutAnywhere() {
    for (qsizetype size = 0; size < good().size() - 1; ++size) {
        const Result<SessionDocument> result = readDocument(good().left(size));
        QVERIFY2(!result.ok(), qPrintable(QString::number(size)));
    }
}

void DocumentBadInputTest::mutations() {
    std::mt19937 random(20250301);
    int readable = 0;
    for (int i = 0; i < 5000; ++i) {
        const QByteArray bytes = mutated(good(), random);
        const Result<SessionDocument> result = readDocument(bytes);
        if (!result) {
            QVERIFY2(!result.error().what.empty(), qPrintable(QStringLiteral("mutation %1").arg(i)));
            continue;
        }
        ++readable;
        // What was taken is something that can be written and is the same then.
        const QByteArray written = writeDocument(result.value());
        const Result<SessionDocument> again = readDocument(written);
        QVERIFY2(again.ok(), qPrintable(messageOf(again)));
        QCOMPARE(writeDocument(again.value()), written);
    }
    QVERIFY2(readable > 500 && readable < 4500, qPrintable(QString::number(readable)));
}

/// Takes no longer than its size says.
void DocumentBadInputTest::large() {
    QElapsedTimer timer;
    timer.start();
    check(head(", \"a\": [" + QByteArray("0,").repeated(2'000'000) + "0], \"targets\": 1"),
          "targets: It has to be a list");
    check(head(", \"targets\": [" + QByteArray("{},").repeated(1'000'000) + "{}]"),
          "target 1, id: It is missing.");
    check(head(", \"a\": \"" + QByteArray("\\u0041").repeated(1'000'000) + "\", \"hits\": 1"),
          "hits: It has to be");
    QByteArray names;
    for (int i = 0; i < 1100; ++i) {
        names += i == 0 ? "\"\"" : ",\"\"";
    }
    check(head(", \"cameras\": {\"kept\": [" + names + "]}"),
          "cameras, kept: It has more than 1000 entries.");
    QVERIFY(timer.elapsed() < 60'000);
}

void DocumentBadInputTest::texts() {
    const std::string json = R"({"\u0061\"b": "\u00e4\ud83d\ude00\n\\\/\t\b\f\r", "c": []})";
    const Result<JsonValue> root = checkJson(json);
    QVERIFY(root.ok());
    std::vector<JsonMember> members;
    QVERIFY(root.value().members(members).ok());
    QCOMPARE(members.size(), std::size_t(2));
    QVERIFY(isKey(members[0].key, "a\"b"));
    QVERIFY(!isKey(members[0].key, "a"));
    QCOMPARE(members[0].value.text(), std::string("ä\U0001F600\n\\/\t\b\f\r"));
    QVERIFY(!members[1].value.first());
}

HITSCOPE_TEST(DocumentBadInputTest, QCoreApplication)

}  // namespace hitscope::document_bad_input_test

#include "document_bad_input_test.moc"
