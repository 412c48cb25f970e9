// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/scene_model.h"

#include <QAbstractItemModelTester>
#include <QPersistentModelIndex>
#include <QSignalSpy>
#include <QTest>
#include <QTextDocumentFragment>
#include <array>

#include "mesh/primitives.h"
#include "session/primitive_target.h"
#include "support/test_program.h"

namespace hitscope::scene_model_test {

namespace {

void hit(Session& session, TargetId target) {
    Hit made;
    made.target = target;
    QVERIFY(session.hits().add(made).ok());
}

}  // namespace

class SceneModelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_model.reset();
        m_session = std::make_unique<Session>();
        loadPaperRow(*m_session, kDefaultPaperRow);
        m_model = std::make_unique<SceneModel>(*m_session);
        m_tester = std::make_unique<QAbstractItemModelTester>(
            m_model.get(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    }
    void cleanup() { m_tester.reset(); }

    void showsTheTargets() {
        QCOMPARE(m_model->rowCount(), 16);
        QCOMPARE(text(0, SceneModel::NameColumn), QStringLiteral("Low-poly cube 1"));
        QCOMPARE(text(3, SceneModel::VerticesColumn), QStringLiteral("6,146"));
        QCOMPARE(text(3, SceneModel::HitsColumn), QStringLiteral("0"));
        QCOMPARE(at(3, SceneModel::VerticesColumn).data(SceneModel::RawValueRole).toULongLong(), 6146ULL);
        QCOMPARE(check(0), Qt::Checked);
        QCOMPARE(m_model->rowOf(m_session->targets()[5]->id), 5);
        QCOMPARE(m_model->targetAt(16), TargetId{});
    }

    void countsHitsAsTheyCome() {
        const TargetId third = m_session->targets()[2]->id;
        hit(*m_session, third);
        hit(*m_session, third);
        hit(*m_session, m_session->targets()[4]->id);
        QCOMPARE(text(2, SceneModel::HitsColumn), QStringLiteral("2"));
        m_session->hits().remove(0);
        QCOMPARE(text(2, SceneModel::HitsColumn), QStringLiteral("1"));
        m_session->undo();
        QCOMPARE(text(2, SceneModel::HitsColumn), QStringLiteral("2"));
        m_session->targets().duplicate(std::array{third});
        QCOMPARE(text(16, SceneModel::HitsColumn), QStringLiteral("2"));
        m_session->targets().reset(std::array{third});
        QCOMPARE(text(2, SceneModel::HitsColumn), QStringLiteral("0"));
        QCOMPARE(text(4, SceneModel::HitsColumn), QStringLiteral("1"));
        loadPaperRow(*m_session, 0);
        QCOMPARE(text(4, SceneModel::HitsColumn), QStringLiteral("0"));
    }

    void pathsAreNoMarkup() {
        const QString path = QStringLiteral("/a/<b>x</b>.obj");
        loadMesh(*m_session, makeCube(2, 1.0f), path);
        const QString tip = at(0, SceneModel::NameColumn).data(Qt::ToolTipRole).toString();
        QCOMPARE(QTextDocumentFragment::fromHtml(tip).toPlainText(), path);
    }

    void rowsComeAndGoOneByOne() {
        QSignalSpy reset(m_model.get(), &QAbstractItemModel::modelReset);
        QSignalSpy removed(m_model.get(), &QAbstractItemModel::rowsRemoved);
        QSignalSpy inserted(m_model.get(), &QAbstractItemModel::rowsInserted);
        const QPersistentModelIndex last(at(15, SceneModel::NameColumn));
        m_session->targets().remove(std::array{m_session->targets()[3]->id, m_session->targets()[8]->id});
        QCOMPARE(removed.count(), 2);
        QCOMPARE(last.row(), 13);
        m_session->undo();
        QCOMPARE(inserted.count(), 2);
        QCOMPARE(last.row(), 15);
        QCOMPARE(text(3, SceneModel::NameColumn), QStringLiteral("High-poly cube 1"));
        m_session->targets().add({planPrimitive({PrimitiveKind::Torus, 9, 2.0f})});
        QCOMPARE(text(16, SceneModel::NameColumn), QStringLiteral("Torus"));
        m_session->redo();  // nothing: adding ended it
        QCOMPARE(m_model->rowCount(), 17);
        QCOMPARE(reset.count(), 0);
        loadTeapot(*m_session);
        QCOMPARE(reset.count(), 1);
        QCOMPARE(m_model->rowCount(), 1);
    }

    void namesAreEdited() {
        QVERIFY(at(1, SceneModel::NameColumn).flags().testFlag(Qt::ItemIsEditable));
        QVERIFY(!at(1, SceneModel::HitsColumn).flags().testFlag(Qt::ItemIsEditable));
        QSignalSpy changed(m_model.get(), &QAbstractItemModel::dataChanged);
        QVERIFY(m_model->setData(at(1, SceneModel::NameColumn), QStringLiteral("Bumper")));
        QCOMPARE(changed.count(), 1);
        QCOMPARE(m_session->targets()[1]->name, QStringLiteral("Bumper"));
        QVERIFY(!m_model->setData(at(1, SceneModel::NameColumn), QStringLiteral(" ")));
        QVERIFY(!m_model->setData(at(1, SceneModel::VerticesColumn), 3));
        m_session->undo();
        QCOMPARE(text(1, SceneModel::NameColumn), QStringLiteral("Low-poly cube 2"));
    }

    /// Its mesh is another one then, and its hits are that one's.
    void countsTheOnlyHitOfAReplacedMesh() {
        hit(*m_session, m_session->targets()[2]->id);
        TargetState same = *m_session->targets()[2];
        m_session->targets().replaceMeshes({&same, 1}, [](const Hit& kept) { return kept; });
        QCOMPARE(m_session->hits().history().size(), std::size_t{1});
        QCOMPARE(text(2, SceneModel::HitsColumn), QStringLiteral("1"));
        m_session->undo();
        QCOMPARE(text(2, SceneModel::HitsColumn), QStringLiteral("1"));
        m_session->redo();
        QCOMPARE(text(2, SceneModel::HitsColumn), QStringLiteral("1"));
    }

    void theEyeHides() {
        QVERIFY(m_model->setData(at(1, SceneModel::VisibleColumn), Qt::Unchecked, Qt::CheckStateRole));
        QVERIFY(!m_session->targets()[1]->visible);
        QCOMPARE(check(1), Qt::Unchecked);
        QVERIFY(!at(1, SceneModel::NameColumn).data(SceneModel::VisibleRole).toBool());
        m_session->undo();
        QCOMPARE(check(1), Qt::Checked);
    }

private:
    [[nodiscard]] QModelIndex at(int row, int column) const { return m_model->index(row, column); }
    [[nodiscard]] QString text(int row, int column) const { return at(row, column).data().toString(); }
    [[nodiscard]] Qt::CheckState check(int row) const {
        return at(row, SceneModel::VisibleColumn).data(Qt::CheckStateRole).value<Qt::CheckState>();
    }

    std::unique_ptr<Session> m_session;
    std::unique_ptr<SceneModel> m_model;
    std::unique_ptr<QAbstractItemModelTester> m_tester;
};

HITSCOPE_TEST(SceneModelTest, QCoreApplication)

}  // namespace hitscope::scene_model_test

#include "scene_model_test.moc"
