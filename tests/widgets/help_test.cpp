// SPDX-License-Identifier: GPL-3.0-or-later
// What the window says about itself: tooltips, why something is disabled, the graphics driver, the tables.
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QGuiApplication>
#include <QHelpEvent>
#include <QMenu>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QToolBar>
#include <QToolButton>
#include <QToolTip>

#include "app/actions/help_actions.h"
#include "app/dialogs/text_window.h"
#include "panels/help/help_text.h"
#include "session/task_list.h"
#include "support/read_back.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::help_test {

namespace {

/// A program in place of hitscope-cli.
class StandIn {
public:
    explicit StandIn(const QByteArray& script) : m_before(qgetenv("HITSCOPE_CLI")) {
        const QString path = m_folder.filePath(QStringLiteral("cli"));
        QFile file(path);
        if (file.open(QIODevice::WriteOnly)) {
            file.write("#!/bin/sh\n" + script);
        }
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        qputenv("HITSCOPE_CLI", path.toLocal8Bit());
    }
    ~StandIn() { qputenv("HITSCOPE_CLI", m_before); }

private:
    QTemporaryDir m_folder;
    QByteArray m_before;
};

bool isNamed(const QAction& action) {
    return !action.isSeparator() && action.menu() == nullptr && !action.text().isEmpty();
}

}  // namespace

class HelpTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() { makeWindow(); }
    void cleanup() { dropWindow(); }

    void tooltipsNameTheirKey() {
        int keys = 0;
        for (const QAction* action : m_window->findChildren<QAction*>()) {
            const QString key = action->shortcut().toString(QKeySequence::NativeText);
            if (isNamed(*action) && !key.isEmpty()) {
                ++keys;
                QVERIFY2(helpOf(*action).contains(key), qPrintable(helpOf(*action)));
            }
        }
        QVERIFY(keys > 40);
        // As one sees it, on each button with an action that has one.
        int buttons = 0;
        for (QToolButton* button : m_window->findChildren<QToolButton*>()) {
            const QAction* action = button->defaultAction();
            if (action == nullptr || action->shortcut().isEmpty() || !button->isVisible()) {
                continue;
            }
            ++buttons;
            const QString key = action->shortcut().toString(QKeySequence::NativeText);
            QVERIFY2(shownAt(*button, button->rect().center()).contains(u'(' + key + u')'),
                     qPrintable(action->text()));
        }
        QVERIFY(buttons >= 5);
    }

    void whatIsDisabledSaysWhy_data() {
        QTest::addColumn<bool>("hits");
        QTest::newRow("a new scene") << false;
        QTest::newRow("with hits") << true;
    }

    void whatIsDisabledSaysWhy() {
        QFETCH(bool, hits);
        if (hits) {
            QVERIFY(m_session->simulation().hitscan(
                m_window->viewport().navigation().rayAt(m_window->viewport().rect().center())));
            QVERIFY(m_window->viewport().syncNow().ok());
        }
        for (QMenu* menu : m_window->findChildren<QMenu*>()) {
            Q_EMIT menu->aboutToShow();  // some are filled then
        }
        int disabled = 0;
        for (const QAction* action : m_window->findChildren<QAction*>()) {
            if (isNamed(*action) && !action->isEnabled()) {
                ++disabled;
                QVERIFY2(!whyDisabled(*action).isEmpty(), qPrintable(action->text()));
            }
        }
        QVERIFY(disabled > 0);
        for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
        }
        for (const QWidget* widget : m_window->findChildren<QWidget*>()) {
            const auto* button = qobject_cast<const QToolButton*>(widget);
            const bool hasAction = button != nullptr && button->defaultAction() != nullptr;
            const bool counts = qobject_cast<const QAbstractButton*>(widget) != nullptr ||
                                qobject_cast<const QComboBox*>(widget) != nullptr;
            // Qt's own parts, of menus and tab bars, are none of ours.
            if (counts && !hasAction && !widget->isEnabled() && !widget->objectName().isEmpty() &&
                !widget->objectName().startsWith(QLatin1String("qt_")) &&
                !widget->objectName().startsWith(QLatin1String("Scroll"))) {
                QVERIFY2(!whyDisabled(*widget).isEmpty(), qPrintable(widget->objectName()));
            }
        }
    }

    void disabledMenuEntriesShowTheReason() {
        auto* undo = find(QStringLiteral("Undo"));
        QMenu* menu = nullptr;
        for (QObject* shown : undo->associatedObjects()) {
            menu = menu == nullptr ? qobject_cast<QMenu*>(shown) : menu;
        }
        QVERIFY(menu != nullptr && !undo->isEnabled());
        menu->popup(m_window->mapToGlobal(QPoint(100, 100)));
        QVERIFY(
            shownAt(*menu, menu->actionGeometry(undo).center()).contains(QStringLiteral("nothing to undo")));
        menu->close();
        // Enabled, it has nothing to say there.
        QVERIFY(m_session->simulation().hitscan(
            m_window->viewport().navigation().rayAt(m_window->viewport().rect().center())));
        QVERIFY(undo->isEnabled());
        QVERIFY(menuHelpOf(*undo).isEmpty());
    }

    void graphicsPageIsCopied() {
        find(QStringLiteral("Graphics"))->trigger();
        auto* page = m_window->findChild<TextWindow*>(QStringLiteral("graphics"));
        QVERIFY(page != nullptr && page->isVisible());
        QTest::mouseClick(page->findChild<QPushButton*>(QStringLiteral("copy")), Qt::LeftButton);
        const QString text = QGuiApplication::clipboard()->text();
        QVERIFY(text.contains(m_window->viewport().scene().rendererName()));
        QVERIFY(text.contains(QString::fromStdString(describe(*m_session->readBack().exactness()))));
        // Line for line what the command prints.
        QProcess command;
        command.start(qEnvironmentVariable("HITSCOPE_CLI"),
                      {QStringLiteral("info"), QStringLiteral("--renderer")});
        QVERIFY(command.waitForFinished(kPatience));
        const auto names = [](const QString& report) {
            QStringList found;
            for (const QString& line : report.split(u'\n')) {
                found << line.left(26).trimmed();
            }
            return found;
        };
        QCOMPARE(names(text), names(QString::fromUtf8(command.readAllStandardOutput())));
        QVERIFY(names(text).contains(QStringLiteral("timer queries")));
        for (const PipelineTraits& traits : allPipelines()) {
            QVERIFY(names(text).contains(QString::fromUtf8(traits.name)));
        }
    }

    void graphicsPageSaysWhyAPipelineIsUnavailable() {
        test::readBackOf(*m_session)
            .setUnavailablePipelines({{PipelineKind::Compute, QStringLiteral("A reason of this test.")}});
        find(QStringLiteral("Graphics"))->trigger();
        QVERIFY(m_window->findChild<TextWindow*>(QStringLiteral("graphics"))
                    ->text()
                    .contains(QStringLiteral("A reason of this test.")));
    }

    void papersTablesAreMeasured() {
        auto& help = *m_window->findChild<HelpActions*>();
        help.measurePaper({QStringLiteral("--quick"), QStringLiteral("--rows"), QStringLiteral("1"),
                           QStringLiteral("--size"), QStringLiteral("64x64"), QStringLiteral("--pipelines"),
                           QStringLiteral("transform-feedback")});
        QVERIFY(m_session->tasks().current() != nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(tables() != nullptr, 2 * kPatience);
        QVERIFY(m_session->tasks().current() == nullptr);
        QVERIFY(tables()->text().contains(QStringLiteral("Transform feedback")));
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("tables.txt"));
        tables()->saveTo(path);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(QString::fromUtf8(file.readAll()), tables()->text());
    }

    void papersTablesShowProgressAndCanBeCancelled() {
        const StandIn standIn(
            "echo 'progress 0.2500 row 3: Compute' >&2; echo 'half a li' >&2; exec sleep 60\n");
        QAction* measure = find(QStringLiteral("Measure the Paper"));
        measure->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(
            m_session->tasks().current() != nullptr && m_session->tasks().current()->fraction == 0.25,
            kPatience);
        QVERIFY(m_session->tasks().current()->what.contains(QStringLiteral("row 3: Compute")));
        QVERIFY(!measure->isEnabled() && !whyDisabled(*measure).isEmpty());
        m_session->tasks().cancel(m_session->tasks().current()->id);
        QTRY_VERIFY_WITH_TIMEOUT(m_session->tasks().current() == nullptr, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(measure->isEnabled(), kPatience);
        QVERIFY(tables() == nullptr);
        QVERIFY(m_window->findChild<QMessageBox*>() == nullptr);
    }

    void papersTablesSayWhatWentWrong() {
        const StandIn standIn("echo 'There is no OpenGL here.' >&2; exit 1\n");
        find(QStringLiteral("Measure the Paper"))->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(m_window->findChild<QMessageBox*>() != nullptr, kPatience);
        auto* box = m_window->findChild<QMessageBox*>();
        QVERIFY(box->informativeText().contains(QStringLiteral("There is no OpenGL here.")));
        box->close();
    }

private:
    [[nodiscard]] TextWindow* tables() {
        return m_window->findChild<TextWindow*>(QStringLiteral("paperTables"));
    }
    [[nodiscard]] QAction* find(const QString& text) {
        for (QAction* action : m_window->findChildren<QAction*>()) {
            QString plain = action->text();
            if (plain.remove(QLatin1Char('&')).startsWith(text)) {
                return action;
            }
        }
        return nullptr;
    }
    static QString shownAt(QWidget& widget, const QPoint& at) {
        QToolTip::hideText();
        QHelpEvent help(QEvent::ToolTip, at, widget.mapToGlobal(at));
        QCoreApplication::sendEvent(&widget, &help);
        return QToolTip::text();
    }
};

HITSCOPE_TEST(HelpTest, QApplication)

}  // namespace hitscope::help_test

#include "help_test.moc"
