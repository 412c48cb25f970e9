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

/// Edit > Copy as File: puts a file on the clipboard, which a file manager or another program pastes. Picture
/// and session are as they were when they were copied; mesh and vertex changes, which may be large, are
/// written when they are pasted, as they are then.
class CopyAsFile : public QObject {
    Q_OBJECT
public:
    struct Parts {
        Viewport& viewport;
        ExportActions& exports;
        std::function<SessionDocument()> capture;
    };
    /// All of them outlive this.
    CopyAsFile(Parts parts, QObject* parent);

    void fill(QMenu& menu);  ///< once

Q_SIGNALS:
    void said(const QString& text);
    void failed(const hitscope::Error& error);

private:
    void copy(const QString& name, const DraggedFile::Write& write);
    void copyPicture();
    void copySession();
    void copyTarget(const QString& ending);
    [[nodiscard]] QString sessionName() const;

    Parts m_parts;
};

}  // namespace hitscope
