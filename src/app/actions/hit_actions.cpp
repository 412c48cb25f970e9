// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/hit_actions.h"

#include <QAction>
#include <QFileDialog>
#include <QMenu>
#include <QSettings>
#include <memory>
#include <utility>

#include "analysis/beside.h"
#include "analysis/hit_files.h"
#include "app/dialogs/dialogs.h"
#include "panels/fields/save_name.h"
#include "panels/help/help_text.h"
#include "panels/hit_history/hit_history_panel.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

QString columnsKey() {
    return QStringLiteral("hitHistory/columns");
}

}  // namespace

HitActions::HitActions(Session& session, HitEffects& effects, QString& folder, QWidget* window)
    : QObject(window),
      m_session(session),
      m_effects(effects),
      m_folder(folder),
      m_window(window),
      m_highlight(session, effects),
      m_editing(session) {
    connect(&session.hits(), &SessionHits::appended, this, &HitActions::follow);
    connect(&session.hits(), &SessionHits::reset, this, &HitActions::follow);
    connect(&session, &Session::sceneReplaced, this, [this] { ++m_scene; });
}

void HitActions::fill(QMenu& menu) {
    m_import = menu.addAction(tr("&Import Hits…"));
    m_import->setToolTip(tr("Append the hits of a CSV or JSON file, on the targets of the same names"));
    m_export = menu.addAction(tr("Export &Hits…"));
    m_export->setToolTip(tr("Write all hits to a CSV or JSON file"));
    connect(m_import, &QAction::triggered, this, &HitActions::chooseImport);
    connect(m_export, &QAction::triggered, this, &HitActions::chooseExport);
    follow();
}

void HitActions::adopt(HitHistoryPanel& panel) {
    m_panel = &panel;
    panel.setColumns(QSettings().value(columnsKey()).toByteArray());
    panel.addHitActions({m_import, m_export});
    connect(&panel, &HitHistoryPanel::rowsSelected, &m_editing, [this](const std::vector<std::size_t>& rows) {
        // A hit that the list does not show can be selected too, alone.
        const std::optional<std::size_t> hit = m_session.hits().selected();
        if (!rows.empty() || !hit) {
            m_editing.select(rows);
        }
    });
}

void HitActions::save(QSettings& settings) const {
    if (m_panel != nullptr) {
        settings.setValue(columnsKey(), m_panel->columns());
    }
}

void HitActions::follow() {
    if (m_export != nullptr) {
        const QString busy = tr("Another file of hits is being read or written.");
        enableIf(*m_export, !m_isBusy && m_session.hits().history().size() > 0,
                 m_isBusy ? busy : tr("There are no hits yet."));
        enableIf(*m_import, !m_isBusy, busy);
    }
}

/// `work` runs on another thread, and what it returns on this one.
void HitActions::run(const std::function<std::function<void()>()>& work) {
    m_isBusy = true;
    follow();
    auto then = std::make_shared<std::function<void()>>();
    workBeside(
        this, [work, then] { *then = work(); },
        [then](HitActions& self, bool done) {
            self.m_isBusy = false;
            self.follow();
            if (done) {
                (*then)();
            } else {
                Q_EMIT self.failed(
                    {"There is not enough memory for so many hits.", {}, "Close other programs."});
            }
        });
}

void HitActions::exportTo(const QString& path) {
    Q_EMIT exportBegan();
    m_effects.finish();
    run([this, path, table = recordsOf(m_session, &m_effects)]() -> std::function<void()> {
        const Status written = writeHitFile(table, path);
        const std::size_t hits = table.hits.size();
        return [this, path, written, hits] {
            if (written) {
                Q_EMIT exported();
                Q_EMIT said(tr("Exported %Ln {hit|hits} to %1", nullptr, trCount(hits)).arg(path));
            } else {
                Q_EMIT failed(written.error());
            }
        };
    });
}

void HitActions::importFrom(const QString& path) {
    run([this, path, scene = m_scene]() -> std::function<void()> {
        const auto table = std::make_shared<Result<HitRecords>>(readHitFile(path));
        return [this, path, scene, table] {
            if (scene == m_scene) {
                takeRecords(*table, path);
            }
        };
    });
}

Status HitActions::importText(const QByteArray& text) {
    const std::string_view bytes(text.constData(), static_cast<std::size_t>(text.size()));
    const Result<HitRecords> table = readHitRecords(bytes, pipelineKeys());
    if (!table) {
        return table.error();
    }
    takeRecords(table, tr("the clipboard"));
    return Done{};
}

/// from: a path, or words.
void HitActions::takeRecords(const Result<HitRecords>& table, const QString& from) {
    const QString other = table ? otherTargetFor(m_session, table.value()) : QString();
    if (!table) {
        Q_EMIT failed(table.error());
    } else if (Status taken = appendRecords(m_session, table.value()); !taken) {
        const Error& error = taken.error();
        Q_EMIT failed({error.what, QFileInfo(from).fileName().toStdString(), error.advice});
    } else {
        const int count = trCount(table.value().hits.size());
        Q_EMIT said(other.isEmpty() ? tr("Imported %Ln {hit|hits} from %1", nullptr, count).arg(from)
                                    : tr("Imported %Ln {hit|hits} of “%1” from %2 onto %3", nullptr, count)
                                          .arg(QString::fromStdString(table.value().targets.begin()->second),
                                               from, other));
    }
}

void HitActions::chooseExport() {
    const QString csv = tr("Comma-separated values (*.csv)");
    const QString json = tr("JSON (*.json)");
    const QString path =
        askSaveName(m_window, {.title = tr("Export All Hits"),
                               .suggested = existingFolder(m_folder) + QStringLiteral("/hits.csv"),
                               .filters = {csv, json},
                               .suffixes = {QStringLiteral("csv"), QStringLiteral("json")}});
    if (path.isEmpty()) {
        return;
    }
    m_folder = QFileInfo(path).absolutePath();
    exportTo(path);
}

void HitActions::chooseImport() {
    const QString path = QFileDialog::getOpenFileName(m_window, tr("Import Hits"), existingFolder(m_folder),
                                                      tr("Hits (*.csv *.json);;All files (*)"));
    if (!path.isEmpty()) {
        m_folder = QFileInfo(path).absolutePath();
        importFrom(path);
    }
}

}  // namespace hitscope
