// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QString>

#include "app/sequence_writer.h"

class QAction;
class QMenu;
class QProgressDialog;

namespace hitscope {

class PictureDialog;

/// Pictures of the viewport as files: at once, of any size, or a sequence of them.
class PictureActions : public QObject {
    Q_OBJECT
public:
    /// `viewport` outlives this; dialogs open over `window`.
    PictureActions(Viewport& viewport, QWidget& window);

    void fill(QMenu& menu);  ///< once
    [[nodiscard]] QAction* saveAction() const { return m_save; }

    /// As the viewport is, at its size.
    [[nodiscard]] Status save(const QString& path);
    [[nodiscard]] Status save(const PictureRequest& request, const QString& path);
    /// A name in the folder of pictures that no file has yet; saves there and says where.
    void saveAtOnce();
    /// Once around the whole scene as it is, refined, in a new folder in that of pictures.
    void saveTurntable();
    /// What it writes, apart from the folder.
    [[nodiscard]] SequenceWriter::Plan turntablePlan() const;
    /// Starts it and shows how far it is; over it, it can be cancelled.
    void writeSequence(const SequenceWriter::Plan& plan);
    [[nodiscard]] SequenceWriter& sequences() { return m_sequences; }

Q_SIGNALS:
    void said(const QString& text);  ///< worth a line in the status bar
    void failed(const hitscope::Error& error);

private:
    void choosePicture();
    void chooseSequence();
    /// Of that name, or with a number behind it; plan.folder in any case. Returns whether it could.
    bool makeNewFolder(SequenceWriter::Plan& plan, const QString& parent, const QString& name);
    void leaveNewFolder();
    void showProgress(int done, int count);
    void endProgress();
    [[nodiscard]] QString endedText(int written) const;
    /// At once, or, with more samples than one, beside what else the window does; then says where.
    void write(const PictureRequest& request, const QString& path);
    [[nodiscard]] PictureRequest requestOf(const PictureDialog& dialog) const;
    [[nodiscard]] QString baseName() const;

    Viewport& m_viewport;
    QWidget& m_window;
    QAction* m_save = nullptr;
    SequenceWriter m_sequences;
    QPointer<QProgressDialog> m_progress;
    QElapsedTimer m_progressTime;
    QString m_newFolder;  ///< made for the pictures that are being written; empty: none was
};

}  // namespace hitscope
