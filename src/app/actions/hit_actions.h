// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <cstdint>
#include <functional>

#include "analysis/hit_highlight.h"
#include "io/hit_records.h"
#include "session/hit_editing.h"

class QAction;
class QMenu;
class QSettings;
class QWidget;

namespace hitscope {

class HitHistoryPanel;

/// The window's commands about the hit history: out to a file and in from one, in CSV or JSON, on another
/// thread; and the panel's columns, kept in the settings. Selected hits light their vertices up.
class HitActions : public QObject {
    Q_OBJECT
public:
    /// All of them outlive this, and so does `window`, which dialogs belong to. `folder` is where they start,
    /// and is set where they end.
    HitActions(Session& session, HitEffects& effects, QString& folder, QWidget* window);

    [[nodiscard]] HitEditing& editing() { return m_editing; }
    void fill(QMenu& menu);
    /// Once both it and the menu are made.
    void adopt(HitHistoryPanel& panel);
    void save(QSettings& settings) const;

    /// Errors, and that it is done, come as signals.
    void exportTo(const QString& path);
    void importFrom(const QString& path);
    /// The same of text; an error: it is no table of hits.
    [[nodiscard]] Status importText(const QByteArray& text);
    [[nodiscard]] bool isBusy() const { return m_isBusy; }

Q_SIGNALS:
    void said(const QString& text);
    void failed(const hitscope::Error& error);
    void exportBegan();  ///< of all hits as they are
    void exported();

private:
    void chooseExport();
    void chooseImport();
    void run(const std::function<std::function<void()>()>& work);
    void follow();
    void takeRecords(const Result<HitRecords>& table, const QString& from);

    Session& m_session;
    HitEffects& m_effects;
    QString& m_folder;
    QWidget* m_window;
    HitHighlight m_highlight;
    HitEditing m_editing;
    HitHistoryPanel* m_panel = nullptr;
    QAction* m_export = nullptr;
    QAction* m_import = nullptr;
    bool m_isBusy = false;
    std::uint64_t m_scene = 0;  ///< counts the scenes, so that a table is not taken into another one
};

}  // namespace hitscope
