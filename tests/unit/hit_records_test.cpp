// SPDX-License-Identifier: GPL-3.0-or-later
// Hits as CSV and JSON: every bit comes back, and what is wrong is said with its line.
#include "io/hit_records.h"

#include <QTest>
#include <bit>
#include <cmath>
#include <random>

#include "analysis/hit_files.h"
#include "support/test_program.h"

namespace hitscope::hit_records_test {

namespace {

const std::vector<std::string> kPipelines{"uniform-array", "reference"};
constexpr auto kHeader =
    "target,point_x_m,point_y_m,point_z_m,direction_x,direction_y,direction_z,max_distance_m,pipeline,"
    "enabled\n";

/// Any finite float's bits.
float anyFloat(std::mt19937& random) {
    for (;;) {
        const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (std::isfinite(value)) {
            return value;
        }
    }
}

HitRecords randomTable(std::mt19937& random, std::size_t count) {
    HitRecords table;
    table.pipelines = kPipelines;
    table.targets = {{TargetId{1}, "High-poly sphere, \"first\"\nof all"}, {TargetId{2}, "Würfel \\ \t 2"}};
    std::uniform_real_distribution<float> part(-1.0f, 1.0f);
    while (table.hits.size() < count) {
        Hit hit;
        // The first is on the first target, as numbers are given when read.
        hit.target = TargetId{table.hits.empty() ? 1 : 1 + static_cast<std::uint32_t>(random() % 2)};
        hit.point = {anyFloat(random), anyFloat(random), -0.0f};
        hit.direction = {part(random), part(random), part(random)};
        hit.constants.power = std::abs(part(random)) * 0.1f;
        hit.time = std::ldexp(static_cast<double>(random()), -7) / 3.0;
        hit.speed = anyFloat(random);
        hit.impulse = part(random);
        hit.enabled = random() % 3 != 0;
        hit.normal = random() % 3 == 0 ? glm::vec3(0.0f) : glm::vec3(part(random), 0.5f, -0.0f);
        hit.triangle = random() % 3 == 0
                           ? kNoIndex
                           : (random() % 2 == 0 ? 100'000 : static_cast<std::uint32_t>(random()));
        hit.pipeline = random() % 3 == 0 ? kUnknownPipeline : static_cast<std::uint8_t>(random() % 2);
        hit.form.profile = static_cast<DentProfile>(random() % kDentProfileKeys.size());
        hit.form.direction = static_cast<DentDirection>(random() % kDentDirectionKeys.size());
        hit.form.curve[random() % kCurvePoints] = part(random);
        hit.form.radius = 0.001f + std::abs(part(random));
        const Result<Hit> checked = checkedHit(hit);
        if (checked) {
            table.hits.push_back(checked.value());
            table.effects.push_back(random() % 2 == 0 ? std::optional<HitEffect>()
                                                      : HitEffect{3, part(random), 5});
        }
    }
    return table;
}

bool sameBits(const Hit& a, const Hit& b, bool zerosHaveSigns) {
    const auto bits = [zerosHaveSigns](const Hit& hit) {
        std::vector<std::uint32_t> all;
        for (const float value :
             {hit.point.x, hit.point.y, hit.point.z, hit.direction.x, hit.direction.y, hit.direction.z,
              hit.normal.x, hit.normal.y, hit.normal.z, hit.speed, hit.impulse, hit.constants.maxDistance,
              hit.constants.power, hit.constants.maxMagnitude}) {
            all.push_back(std::bit_cast<std::uint32_t>(zerosHaveSigns ? value : value + 0.0f));
        }
        return all;
    };
    return a == b && bits(a) == bits(b) && a.pipeline == b.pipeline;
}

}  // namespace

class HitRecordsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyBitComesBack_data() {
        QTest::addColumn<bool>("json");
        QTest::addRow("csv") << false;
        QTest::addRow("json") << true;
    }
    void everyBitComesBack() {
        QFETCH(bool, json);
        std::mt19937 random(5);
        const HitRecords table = randomTable(random, 3000);
        const std::string text = json ? toJson(table) : toCsv(table);
        const Result<HitRecords> read = readHitRecords(text, kPipelines);
        QVERIFY2(read.ok(), read.ok() ? "" : read.error().message().c_str());
        QCOMPARE(read.value().hits.size(), table.hits.size());
        for (std::size_t i = 0; i < table.hits.size(); ++i) {
            QVERIFY(sameBits(read.value().hits[i], table.hits[i], !json));
        }
        QVERIFY(read.value().targets == table.targets);
    }

    void noHits() {
        QCOMPARE(readHitRecords(toCsv({}), kPipelines).value().hits.size(), std::size_t{0});
        QCOMPARE(readHitRecords(toJson({}), kPipelines).value().hits.size(), std::size_t{0});
        QCOMPARE(readHitRecords("[]", kPipelines).value().hits.size(), std::size_t{0});
    }

    void handWritten() {
        const std::string text =
            std::string("\xef\xbb\xbf") + kHeader +
            "\"A \"\"b\"\", c\",1,2.5,-3e-1,0,0,-2,,,\r\n\r\nB,0,1e-50,0,1,0,0,0.25,reference,0";
        const Result<HitRecords> read = readHitRecords(text, kPipelines);
        QVERIFY2(read.ok(), read.ok() ? "" : read.error().message().c_str());
        const std::vector<Hit>& hits = read.value().hits;
        QCOMPARE(hits.size(), std::size_t{2});
        QVERIFY(hits[0].direction == glm::vec3(0.0f, 0.0f, -1.0f));  // made unit
        QVERIFY(hits[0].point == glm::vec3(1.0f, 2.5f, -0.3f));
        QVERIFY(hits[0].constants == DeformationConstants());
        QVERIFY(hits[0].enabled);
        QVERIFY(!hits[1].enabled);
        QVERIFY(hits[1].point == glm::vec3(0.0f));  // too small for a float
        QCOMPARE(hits[1].constants.maxDistance, 0.25f);
        QCOMPARE(hits[1].pipeline, std::uint8_t{1});
        QCOMPARE(read.value().targets.at(hits[0].target), std::string("A \"b\", c"));
    }

    void badFiles_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("message");
        const auto csv = [](const char* name, const QByteArray& lines, const char* message) {
            QTest::addRow("%s", name) << kHeader + lines << QString::fromUtf8(message);
        };
        const auto any = [](const char* name, const QByteArray& text, const char* message) {
            QTest::addRow("%s", name) << text << QString::fromUtf8(message);
        };
        any("empty", "", "line 1: “” is no column");
        any("binary", QByteArray("\0\1\2\xff", 4), "line 1");
        any("unknown column", "target,colour\n", "line 1: “colour” is no column");
        any("column twice", "target,target\n", "line 1: The column “target” is there twice");
        any("column missing", "target,point_x_m\n", "line 1: The column “point_y_m” is missing");
        csv("not a number", "A,1,2,three,0,0,1,,,\n", "line 2: point_z_m is “three”");
        csv("a number and more", "A,1,2,3m,0,0,1,,,\n", "line 2: point_z_m is “3m”");
        csv("NaN", "A,nan,2,3,0,0,1,,,\n", "line 2: point_x_m is “nan”, which is not a finite number");
        csv("infinite", "A,1,inf,3,0,0,1,,,\n", "line 2: point_y_m");
        csv("too large", "A,1,1e39,3,0,0,1,,,\n", "line 2: point_y_m");
        csv("hexadecimal", "A,0x10,1,3,0,0,1,,,\n", "line 2: point_x_m");
        csv("decimal comma", "A,1,2,3,0,0,1,\"0,5\",,\n", "line 2: max_distance_m is “0,5”");
        csv("missing value", "A,,2,3,0,0,1,,,\n", "line 2: “point_x_m” is missing");
        csv("no target", ",1,2,3,0,0,1,,,\n", "line 2: “target” is missing");
        csv("too few fields", "A,1,2,3\n", "line 2: The line has 4 fields, the header 10");
        csv("too many fields", "A,1,2,3,0,0,1,,,,9\n", "line 2: The line has 11 fields");
        csv("no direction", "A,1,2,3,0,0,0,,,\n", "line 2: The hit has no direction");
        csv("constant out of range", "A,1,2,3,0,0,1,-1,,\n", "line 2: Max distance is -1");
        csv("unknown pipeline", "A,1,2,3,0,0,1,,magic,\n", "line 2: pipeline is “magic”");
        csv("enabled", "A,1,2,3,0,0,1,,,yes\n", "line 2: enabled is “yes”, which is not 0 or 1");
        csv("open quote", "A,1,2,3,0,0,1,,,\n\"B,1,2,3\n\n", "line 3: A quotation mark is not closed");
        csv("quote inside", "A\"B,1,2,3,0,0,1,,,\n", "line 2: A quotation mark stands in the middle");
        csv("text after quote", "\"A\"B,1,2,3,0,0,1,,,\n", "line 2: Text follows a quoted field");
        csv("line after a break in a field", "\"A\nB\",1,2,3,0,0,1,,,\nA,x,2,3,0,0,1,,,\n",
            "line 4: point_x_m");
        const QByteArray good =
            R"({"target":"A","point_x_m":1,"point_y_m":2,"point_z_m":3,"direction_x":0,"direction_y":0,"direction_z":1})";
        any("no JSON", "{\"hits\": [\n{\"target\": }]}", "line 2: This is not JSON");
        any("cut short", "{\"hits\": [\n" + good + ",\n", "This is not JSON");
        any("NaN in JSON", "[{\"point_x_m\": NaN}]", "line 1: This is not JSON");
        any("another object", "{\"meshes\": []}", "line 1: “meshes” is nothing");
        any("no array", "{\"hits\": 5}", "line 1: There is no array");
        any("hit is a number", "{\"hits\": [\n" + good + ",\n5]}", "not an object");
        any("key missing", "[" + good + ",\n{\"target\": \"[{\"}]", "line 2: “point_x_m” is missing");
        any("unknown key", "[\n" + QByteArray(good).replace("}", ",\"size\":1}") + "]",
            "line 2: “size” is nothing");
        any("text for a number", "[" + QByteArray(good).replace(":3", ":\"3\"") + "]",
            "“point_z_m” has a value of the wrong kind");
        any("too large in JSON", "[" + QByteArray(good).replace(":3", ":1e39") + "]",
            "line 1: point_z_m is “1e+39”");
        any("no triangle", "[" + QByteArray(good).replace("}", ",\"triangle\":1.5}") + "]",
            "line 1: triangle is “1.5”");
        any("no direction in JSON",
            "{\"hits\":[" + good + ",\n\n" + QByteArray(good).replace("_z\":1", "_z\":0") + "]}",
            "line 3: The hit has no direction");
    }
    void badFiles() {
        QFETCH(QByteArray, text);
        QFETCH(QString, message);
        const Result<HitRecords> read =
            readHitRecords({text.data(), static_cast<std::size_t>(text.size())}, kPipelines);
        QVERIFY(!read.ok());
        const QString said = QString::fromStdString(read.error().message());
        QVERIFY2(said.contains(message), qPrintable(said));
    }

    void brokenFilesDoNoHarm() {
        std::mt19937 random(8);
        const HitRecords table = randomTable(random, 5);
        for (const std::string& whole : {toCsv(table), toJson(table)}) {
            for (int i = 0; i < 3000; ++i) {
                std::string text = whole;
                for (std::size_t k = 1 + random() % 3; k > 0; --k) {
                    text[random() % text.size()] = static_cast<char>(random() % 256);
                }
                text.resize(random() % 4 == 0 ? random() % text.size() : text.size());
                const Result<HitRecords> read = readHitRecords(text, kPipelines);
                QVERIFY(read.ok() || !read.error().where.empty());
            }
        }
    }

    void hitsFindTheirTargetsByName() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        Hit hit;
        hit.target = session.targets()[3]->id;
        hit.point = {0.1f, 0.2f, 0.3f};
        hit.pipeline = static_cast<std::uint8_t>(PipelineKind::Compute);
        QVERIFY(session.hits().add(hit).ok());
        hit.target = session.targets()[1]->id;
        QVERIFY(session.hits().add(hit).ok());
        const std::string text = toCsv(recordsOf(session, nullptr));
        const std::vector<Hit> before(session.hits().history().hits().begin(),
                                      session.hits().history().hits().end());

        session.hits().clear();
        const Result<HitRecords> read = readHitRecords(text, pipelineKeys());
        QVERIFY(read.ok());
        QVERIFY(appendRecords(session, read.value()).ok());
        QVERIFY(std::ranges::equal(session.hits().history().hits(), before));
        QVERIFY(pipelineOf(session.hits().history().hits()[0]) == PipelineKind::Compute);
        session.undo();  // one step
        QCOMPARE(session.hits().history().size(), std::size_t{0});

        QVERIFY(session.targets().rename(session.targets()[3]->id, QStringLiteral("Other")).ok());
        const Status refused = appendRecords(session, read.value());
        QVERIFY(!refused.ok());
        QVERIFY(refused.error().what.find("“" + read.value().targets.at(TargetId{1}) + "”") !=
                std::string::npos);
        QCOMPARE(session.hits().history().size(), std::size_t{0});
    }

    void triangleIsOneOfTheTarget() {
        Session session;
        loadTeapot(session);
        const Target& target = *session.targets().front();
        const auto triangles = static_cast<std::uint32_t>(target.shape.render->triangles.size() / 3);
        HitRecords table;
        table.targets[TargetId{1}] = target.name.toStdString();
        Hit hit;
        hit.target = TargetId{1};
        hit.triangle = triangles - 1;
        table.hits = {hit, hit};
        QVERIFY(appendRecords(session, table).ok());
        table.hits[1].triangle = kNoIndex;
        QVERIFY(appendRecords(session, table).ok());
        table.hits[1].triangle = triangles;
        const Status refused = appendRecords(session, table);
        QVERIFY(!refused.ok());
        QCOMPARE(QString::fromStdString(refused.error().message()).section(QLatin1Char(','), 0, 0),
                 QStringLiteral("hit 2: Its triangle is %1").arg(triangles));
        QCOMPARE(session.hits().history().size(), std::size_t{4});
    }

    /// As of a coarser version of the mesh, which has another name.
    void hitsOfOneTargetGoToTheOnlyOne() {
        Session session;
        loadTeapot(session);
        HitRecords table;
        table.targets[TargetId{1}] = "bunny";
        Hit hit;
        hit.target = TargetId{1};
        hit.point = {0.1f, 0.2f, 0.3f};
        hit.triangle = 12;
        table.hits = {hit};
        const Target& only = *session.targets().front();
        QCOMPARE(otherTargetFor(session, table), only.name);
        QVERIFY(appendRecords(session, table).ok());
        QVERIFY(session.hits().history().hits()[0].target == only.id);
        QCOMPARE(session.hits().history().hits()[0].triangle, kNoIndex);
        table.targets[TargetId{1}] = only.name.toStdString();
        QVERIFY(otherTargetFor(session, table).isEmpty());
        table.targets[TargetId{1}] = "bunny";
        table.targets[TargetId{2}] = "cow";  // which of them would it be?
        QVERIFY(!appendRecords(session, table).ok());
    }
};

HITSCOPE_TEST(HitRecordsTest, QCoreApplication)

}  // namespace hitscope::hit_records_test

#include "hit_records_test.moc"
