// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/undo_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include "support/test_program.h"

namespace hitscope::undo_model_test {

class UndoModelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_session = std::make_unique<Session>();
        loadTeapot(*m_session);
        m_model = std::make_unique<UndoModel>(*m_session);
        m_tester = std::make_unique<QAbstractItemModelTester>(
            m_model.get(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    }
    void cleanup() {
        m_tester.reset();
        m_model.reset();
    }

    void followsTheSteps() {
        QCOMPARE(texts(), QStringList{QStringLiteral("Start")});
        hit();
        hit();
        m_session->hits().clear();
        const QStringList all{QStringLiteral("Start"), QStringLiteral("Hit 1"), QStringLiteral("Hit 2"),
                              QStringLiteral("Clear 2 Hits")};
        QCOMPARE(texts(), all);
        QCOMPARE(m_model->current(), 3);
        m_session->undo();
        m_session->undo();
        QCOMPARE(texts(), all);  // still there to be made again
        QCOMPARE(m_model->current(), 1);
        QVERIFY(isDone(1) && !isDone(2) && !isDone(3));
        loadPaperRow(*m_session, 0);
        QCOMPARE(texts(), (QStringList{all[0], all[1], QStringLiteral("Load Scene")}));
        m_session->goToStep(0);
        QCOMPARE(m_model->current(), 0);
        QVERIFY(!isDone(1));
        m_session->goToStep(2);
        QCOMPARE(m_session->targets().size(), std::size_t{16});
        QVERIFY(m_model->summary().startsWith(QStringLiteral("2 steps, ")));
    }

    void aHitTouchesItsRowAlone() {
        hit();
        const QSignalSpy reset(m_model.get(), &QAbstractItemModel::modelReset);
        const QSignalSpy inserted(m_model.get(), &QAbstractItemModel::rowsInserted);
        const QSignalSpy changed(m_model.get(), &QAbstractItemModel::dataChanged);
        hit();
        QCOMPARE(reset.size(), 0);
        QCOMPARE(inserted.size(), 1);
        QCOMPARE(changed.size(), 1);
        QCOMPARE(changed[0][0].toModelIndex().row(), 1);
    }

private:
    void hit() {
        Hit made;
        made.target = m_session->targets().front()->id;
        QVERIFY(m_session->hits().add(made).ok());
    }
    [[nodiscard]] QStringList texts() const {
        QStringList texts;
        for (int row = 0; row < m_model->rowCount(); ++row) {
            texts << m_model->index(row).data().toString();
        }
        return texts;
    }
    [[nodiscard]] bool isDone(int row) const {
        return m_model->index(row).data(UndoModel::DoneRole).toBool();
    }

    std::unique_ptr<Session> m_session;
    std::unique_ptr<UndoModel> m_model;
    std::unique_ptr<QAbstractItemModelTester> m_tester;
};

HITSCOPE_TEST(UndoModelTest, QCoreApplication)

}  // namespace hitscope::undo_model_test

#include "undo_model_test.moc"
