// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/vertex_selection.h"

#include <QSignalSpy>
#include <QTest>
#include <array>

#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::vertex_selection_test {

using Combine = VertexSelection::Combine;

namespace {

std::vector<std::uint32_t> listed(std::span<const std::uint32_t> vertices) {
    return {vertices.begin(), vertices.end()};
}

using Vertices = std::vector<std::uint32_t>;

}  // namespace

class VertexSelectionTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_session = std::make_unique<Session>();
        loadPaperRow(*m_session, kDefaultPaperRow);
        m_first = m_session->targets()[0]->id;
        m_second = m_session->targets()[1]->id;
    }

    void combines() {
        VertexSelection& selection = m_session->selection();
        QSignalSpy changed(&selection, &VertexSelection::selectionChanged);
        selection.select(m_first, {7, 3, 7, 5}, Combine::Replace);
        QCOMPARE(listed(selection.vertices(m_first)), (Vertices{3, 5, 7}));
        selection.select(m_second, {1}, Combine::Add);
        QCOMPARE(selection.count(), std::size_t{4});
        QCOMPARE(selection.targets(), (std::vector<TargetId>{m_first, m_second}));
        selection.select(m_first, {4, 5}, Combine::Add);
        QCOMPARE(listed(selection.vertices(m_first)), (Vertices{3, 4, 5, 7}));
        selection.select(m_first, {3, 7, 9}, Combine::Remove);
        QCOMPARE(listed(selection.vertices(m_first)), (Vertices{4, 5}));
        QVERIFY(selection.isSelected({m_first, 4}));
        QVERIFY(!selection.isSelected({m_second, 4}));
        QCOMPARE(changed.count(), 4);
        selection.select(m_first, {4}, Combine::Add);
        QCOMPARE(changed.count(), 4);  // nothing new
        selection.select(m_second, {8}, Combine::Replace);
        QVERIFY(selection.vertices(m_first).empty());
        QCOMPARE(selection.count(), std::size_t{1});
        selection.select(m_second, {8}, Combine::Remove);
        QVERIFY(selection.targets().empty());
        QCOMPARE(changed.count(), 6);
    }

    void passesOverWhatIsNotThere() {
        VertexSelection& selection = m_session->selection();
        const auto count =
            static_cast<std::uint32_t>(m_session->targets().find(m_first)->deformed.positions().size());
        selection.select(m_first, {count, count - 1}, Combine::Replace);
        QCOMPARE(listed(selection.vertices(m_first)), (Vertices{count - 1}));
        selection.select(TargetId{999}, {0}, Combine::Replace);
        QCOMPARE(selection.count(), std::size_t{0});
        selection.setPicked(VertexRef{m_first, count});
        QVERIFY(!selection.picked());
        selection.setHovered(VertexRef{TargetId{999}, 0});
        QVERIFY(!selection.hovered());
    }

    void saysWhatChanged() {
        VertexSelection& selection = m_session->selection();
        QSignalSpy hovered(&selection, &VertexSelection::hoveredChanged);
        QSignalSpy picked(&selection, &VertexSelection::pickedChanged);
        selection.setHovered(VertexRef{m_first, 2});
        selection.setHovered(VertexRef{m_first, 2});
        selection.setPicked(VertexRef{m_first, 2});
        QCOMPARE(hovered.count(), 1);
        QCOMPARE(picked.count(), 1);
        selection.clear();
        QCOMPARE(hovered.count(), 2);
        QCOMPARE(picked.count(), 2);
        QVERIFY(!selection.picked());
    }

    void forgetsTargetsThatGo() {
        VertexSelection& selection = m_session->selection();
        selection.select(m_first, {1, 2}, Combine::Replace);
        selection.select(m_second, {3}, Combine::Add);
        selection.setPicked(VertexRef{m_first, 1});
        selection.setHovered(VertexRef{m_second, 1});
        m_session->targets().remove(std::array{m_first});
        QVERIFY(selection.vertices(m_first).empty());
        QCOMPARE(selection.count(), std::size_t{1});
        QVERIFY(!selection.picked());
        QVERIFY(selection.hovered().has_value());
        loadPaperRow(*m_session, 0);
        QCOMPARE(selection.count(), std::size_t{0});
        QVERIFY(!selection.hovered());
    }

private:
    std::unique_ptr<Session> m_session;
    TargetId m_first;
    TargetId m_second;
};

HITSCOPE_TEST(VertexSelectionTest, QCoreApplication)

}  // namespace hitscope::vertex_selection_test

#include "vertex_selection_test.moc"
