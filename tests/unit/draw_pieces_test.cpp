// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bounded_draw.h"

#include <QTest>
#include <algorithm>
#include <random>
#include <vector>

#include "support/test_program.h"

namespace hitscope::draw_pieces_test {

using render::DrawOrder;
using render::DrawPieces;

namespace {

/// The indices of a piece, as its draw call reads them.
void append(const IndexRuns& piece, std::vector<std::uint32_t>& drawn) {
    for (std::size_t i = 0; i < piece.counts.size(); ++i) {
        const auto first = reinterpret_cast<std::uintptr_t>(piece.starts[i]) / sizeof(std::uint32_t);
        for (std::size_t k = 0; k < static_cast<std::size_t>(piece.counts[i]); ++k) {
            drawn.push_back(static_cast<std::uint32_t>(first + k));
        }
    }
}

/// Runs of whole triangles with gaps between them.
std::vector<IndexRun> scatteredRuns(std::uint32_t end) {
    std::mt19937 random(3);
    std::uniform_int_distribution<std::uint32_t> triangles(1, 5'000);
    std::vector<IndexRun> runs;
    for (std::uint32_t first = 3 * triangles(random); first < end;) {
        const std::uint32_t behind = std::min(first + 3 * triangles(random), end);
        runs.push_back({first, behind});
        first = behind + 3 * triangles(random);
    }
    return runs;
}

std::vector<std::uint32_t> indicesOf(const std::vector<IndexRun>& runs, const IndexRun& range) {
    std::vector<std::uint32_t> indices;
    for (const IndexRun& run : runs) {
        for (std::uint32_t i = std::max(run.first, range.first); i < std::min(run.end, range.end); ++i) {
            indices.push_back(i);
        }
    }
    return indices;
}

}  // namespace

class DrawPiecesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void eachIndexIsDrawnOnce_data() {
        QTest::addColumn<bool>("scattered");
        QTest::addColumn<quint32>("first");
        QTest::addColumn<quint32>("end");
        const quint32 most = DrawPieces::kMost;
        for (const bool scattered : {false, true}) {
            const auto row = [scattered](const char* name, quint32 first, quint32 end) {
                QTest::addRow("%s, %s", scattered ? "runs" : "all", name) << scattered << first << end;
            };
            row("none", 300, 300);
            row("a triangle", 0, 3);
            row("a piece", 30'000, 30'000 + most);
            row("a triangle more", 30'000, 30'003 + most);
            row("many pieces", 99'999, 99'999 + 5 * most + 15);
        }
    }
    void eachIndexIsDrawnOnce() {
        QFETCH(const bool, scattered);
        QFETCH(const quint32, first);
        QFETCH(const quint32, end);
        const IndexRun range{first, end};
        const std::vector<IndexRun> runs =
            scattered ? scatteredRuns(2'000'000) : std::vector<IndexRun>{{0, 2'000'000}};
        const std::vector<std::uint32_t> wanted = indicesOf(runs, range);
        for (const DrawOrder order : {DrawOrder::AsGiven, DrawOrder::Any}) {
            DrawPieces pieces(runs, range, order);
            std::vector<std::uint32_t> drawn;
            for (IndexRuns piece = pieces.next(); piece.indices > 0; piece = pieces.next()) {
                QVERIFY(piece.indices <= DrawPieces::kMost);
                for (const int count : piece.counts) {
                    QCOMPARE(count % 3, 0);
                }
                append(piece, drawn);
            }
            if (order == DrawOrder::Any) {
                std::sort(drawn.begin(), drawn.end());
            }
            QVERIFY(drawn == wanted);
        }
    }

    void aPieceHasTrianglesOfSeveralPlaces() {
        const std::vector<IndexRun> all{{0, 40 * DrawPieces::kMost}};
        DrawPieces pieces(all, all.front(), DrawOrder::Any);
        std::vector<std::uint32_t> drawn;
        append(pieces.next(), drawn);
        QVERIFY(drawn.front() < DrawPieces::kMost);
        QVERIFY(drawn.back() > 30 * DrawPieces::kMost);
    }
};

HITSCOPE_TEST(DrawPiecesTest, QCoreApplication)

}  // namespace hitscope::draw_pieces_test

#include "draw_pieces_test.moc"
