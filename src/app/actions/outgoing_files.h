// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

#include "core/result.h"
#include "models/dragged_file.h"

class QMenu;

namespace hitscope {

class ExportActions;
class Viewport;
struct SessionDocument;

/// What the window shows as files for other programs: on the clipboard (Edit > Copy as File, Copy as Text),
/// or dragged out. Picture and session are as they were when they were copied; mesh and vertex changes, which
/// may be large, are written when they are pasted or dropped, as they are then.
class OutgoingFiles : public QObject {
    Q_OBJECT
public:
    struct Parts {
        Viewport& viewport;
        ExportActions& exports;
        std::function<SessionDocument()> capture;
    };
    /// All of them outlive this.
    OutgoingFiles(Parts parts, QObject* parent);

    void fill(QMenu& menu);  ///< once

    // The caller owns them. Null: there is none, which was said where it is an error.
    [[nodiscard]] DraggedFile* picture();
    [[nodiscard]] DraggedFile* session();
    [[nodiscard]] DraggedFile* mesh() { return target(QStringLiteral(".obj")); }  ///< of the target in focus
    [[nodiscard]] DraggedFile* changes() { return target(QStringLiteral(".csv")); }  ///< likewise

Q_SIGNALS:
    void said(const QString& text);
    void failed(const hitscope::Error& error);

private:
    void fillFiles(QMenu& menu);
    void fillTexts(QMenu& menu);
    void addOfTarget(QMenu& menu, const QString& text, const QString& tip, const std::function<void()>& act);
    void copy(DraggedFile* file);
    void copySessionText();
    void copyTargetText(const QString& ending);
    void takeText(const QByteArray& text, const QString& what);
    [[nodiscard]] DraggedFile* target(const QString& ending);
    [[nodiscard]] QString sessionName() const;

    Parts m_parts;
};

}  // namespace hitscope
