// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/picture_actions.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QProgressDialog>
#include <QSettings>
#include <QStandardPaths>
#include <algorithm>

#include "app/dialogs/picture_dialog.h"
#include "io/save_image.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

const QString& folderKey() {
    static const QString key = QStringLiteral("picture/folder");
    return key;
}

QString pictureFolder() {
    const QString folder = QSettings().value(folderKey()).toString();
    return !folder.isEmpty() && QFileInfo(folder).isDir()
               ? folder
               : QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
}

void rememberFolder(const QString& folder) {
    QSettings().setValue(folderKey(), folder);
}

/// The name first: of a long path the status bar shows the beginning.
QString savedText(const QString& path) {
    const QFileInfo file(path);
    return PictureActions::tr("Saved %1 in %2")
        .arg(file.fileName(), QDir::toNativeSeparators(file.absolutePath()));
}

QAction* addAction(QMenu& menu, const QString& text, const QKeySequence& key) {
    QAction* action = menu.addAction(text);
    action->setShortcut(key);
    return action;
}

}  // namespace

PictureActions::PictureActions(Viewport& viewport, QWidget& window)
    : QObject(&window), m_viewport(viewport), m_window(window), m_sequences(viewport) {
    connect(&m_sequences, &SequenceWriter::progressed, this, [this](int written, int count) {
        if (m_progress) {
            m_progress->setMaximum(count);
            m_progress->setValue(written);
        }
    });
    connect(&m_sequences, &SequenceWriter::ended, this, [this](int written) {
        endProgress();
        Q_EMIT said(tr("%n picture(s) written.", nullptr, written));
    });
    connect(&m_sequences, &SequenceWriter::failed, this, [this](const Error& error) {
        endProgress();
        Q_EMIT failed(error);
    });
}

void PictureActions::fill(QMenu& menu) {
    connect(addAction(menu, tr("Save &Picture"), Qt::Key_F12), &QAction::triggered, this,
            &PictureActions::saveAtOnce);
    connect(addAction(menu, tr("Save Pic&ture As…"), tr("Shift+F12")), &QAction::triggered, this,
            &PictureActions::choosePicture);
    connect(addAction(menu, tr("Save Picture Se&quence…"), {}), &QAction::triggered, this,
            &PictureActions::chooseSequence);
}

QString PictureActions::baseName() const {
    QString name = m_viewport.session().sceneName();
    std::replace_if(
        name.begin(), name.end(), [](QChar letter) { return !letter.isLetterOrNumber() && letter != u'-'; },
        u'_');
    return name.isEmpty() ? QStringLiteral("hitscope") : name;
}

Status PictureActions::save(const QString& path) {
    return save(m_viewport.pictureRequest(), path);
}

Status PictureActions::save(const PictureRequest& request, const QString& path) {
    const Result<Image> image = m_viewport.drawPicture(request);
    return image ? savePicture(image.value(), path) : Status(image.error());
}

void PictureActions::saveAtOnce() {
    const QString folder = pictureFolder();
    QDir().mkpath(folder);
    int number = 1;
    while (QFileInfo::exists(sequencePath(folder, baseName(), number, 1))) {
        ++number;
    }
    const QString path = sequencePath(folder, baseName(), number, 1);
    if (Status saved = save(path); !saved) {
        Q_EMIT failed(saved.error());
    } else {
        Q_EMIT said(savedText(path));
    }
}

PictureRequest PictureActions::requestOf(const PictureDialog& dialog) const {
    PictureRequest request = m_viewport.pictureRequest();
    request.width = dialog.pictureSize().width();
    request.height = dialog.pictureSize().height();
    request.options.transparent = dialog.isTransparent();
    request.options.floor = dialog.hasFloor();
    request.labels = dialog.hasLabels();
    request.selectionMarks = dialog.hasSelectionMarks();
    return request;
}

void PictureActions::choosePicture() {
    const PictureRequest shown = m_viewport.pictureRequest();
    PictureDialog dialog(PictureDialog::Kind::Picture, {shown.width, shown.height}, 0, &m_window);
    QSettings settings;
    dialog.load(settings);
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    dialog.save(settings);
    const QStringList suffixes = pictureSuffixes();
    QStringList filters;
    for (const QString& suffix : suffixes) {
        filters << tr("%1 (*.%2)", "PNG (*.png)").arg(suffix.toUpper(), suffix);
    }
    QString filter = filters.constFirst();
    QString path = QFileDialog::getSaveFileName(
        &m_window, tr("Save picture"), QDir(pictureFolder()).filePath(baseName() + QStringLiteral(".png")),
        filters.join(QStringLiteral(";;")), &filter);
    if (path.isEmpty()) {
        return;
    }
    if (QFileInfo(path).suffix().isEmpty()) {
        path += u'.' + suffixes.value(filters.indexOf(filter), suffixes.constFirst());
    }
    rememberFolder(QFileInfo(path).absolutePath());
    if (Status saved = save(requestOf(dialog), path); !saved) {
        Q_EMIT failed(saved.error());
    } else {
        Q_EMIT said(savedText(path));
    }
}

void PictureActions::chooseSequence() {
    const PictureRequest shown = m_viewport.pictureRequest();
    const Session& session = m_viewport.session();
    PictureDialog dialog(PictureDialog::Kind::Sequence, {shown.width, shown.height},
                         session.hits().history().size() - session.hits().disabled(), &m_window);
    QSettings settings;
    dialog.load(settings);
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    dialog.save(settings);
    const QString folder =
        QFileDialog::getExistingDirectory(&m_window, tr("Folder for the pictures"), pictureFolder());
    if (!folder.isEmpty()) {
        rememberFolder(folder);
        writeSequence({requestOf(dialog), dialog.turntable(), folder, baseName()});
    }
}

void PictureActions::endProgress() {
    if (m_progress) {
        // Not at once: it may be its own button that was pressed.
        m_progress->hide();
        m_progress->deleteLater();
        m_progress.clear();
    }
}

void PictureActions::writeSequence(const SequenceWriter::Plan& plan) {
    if (Status started = m_sequences.start(plan); !started) {
        Q_EMIT failed(started.error());
        return;
    }
    endProgress();
    m_progress = new QProgressDialog(tr("Drawing pictures"), tr("Cancel"), 0, 0, &m_window);
    m_progress->setObjectName(QStringLiteral("sequenceProgress"));
    m_progress->setWindowModality(Qt::WindowModal);
    m_progress->setAutoReset(false);
    m_progress->setAutoClose(false);
    connect(m_progress, &QProgressDialog::canceled, &m_sequences, &SequenceWriter::cancel);
    m_progress->show();
}

}  // namespace hitscope
