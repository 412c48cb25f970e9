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
#include <cmath>
#include <utility>

#include "analysis/changed_settings.h"
#include "app/dialogs/picture_dialog.h"
#include "io/save_image.h"
#include "models/progress_text.h"
#include "panels/fields/save_name.h"
#include "panels/icons/themed_icon.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr QSize kTurntableSize(1920, 1080);  // pixels
constexpr int kTurntablePictures = 90;       // one every four degrees

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

/// For dialogs, which take a path that does not exist for a file's name.
QString existingFolder() {
    const QString folder = pictureFolder();
    return QFileInfo(folder).isDir() ? folder : QDir::homePath();
}

void rememberFolder(const QString& folder) {
    ChangedSettings()->setValue(folderKey(), folder);
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
        if (m_sequences.plan().picture.samples <= 1) {
            showProgress(written, count);
        }
    });
    connect(&m_sequences, &SequenceWriter::sampled, this, &PictureActions::showProgress);
    connect(&m_sequences, &SequenceWriter::ended, this, [this](int written) {
        endProgress();
        leaveNewFolder();
        Q_EMIT said(endedText(written));
    });
    connect(&m_sequences, &SequenceWriter::failed, this, [this](const Error& error) {
        endProgress();
        leaveNewFolder();
        Q_EMIT failed(error);
    });
}

QString PictureActions::endedText(int written) const {
    const SequenceWriter::Plan& plan = m_sequences.plan();
    if (written == 0) {
        return tr("Cancelled. Nothing was written.");
    }
    if (!plan.path.isEmpty()) {
        return savedText(plan.path);
    }
    const QString folder = QDir::toNativeSeparators(plan.folder);
    return written < m_sequences.count() ? tr("Cancelled after %1 of %2 pictures, in %3")
                                               .arg(written)
                                               .arg(m_sequences.count())
                                               .arg(folder)
                                         : tr("Pictures written: %1, in %2").arg(written).arg(folder);
}

void PictureActions::fill(QMenu& menu) {
    m_save = addAction(menu, tr("Save &Picture"), Qt::Key_F12);
    m_save->setIcon(themedIcon(QStringLiteral("picture")));
    connect(m_save, &QAction::triggered, this, &PictureActions::saveAtOnce);
    connect(addAction(menu, tr("Save Pic&ture As…"), tr("Shift+F12")), &QAction::triggered, this,
            &PictureActions::choosePicture);
    connect(addAction(menu, tr("Save Picture Seq&uence…"), {}), &QAction::triggered, this,
            &PictureActions::chooseSequence);
    QAction* turntable = addAction(menu, tr("Save Turnta&ble"), {});
    turntable->setToolTip(
        tr("Pictures once around the whole scene, refined, as it is shown now, into a new folder beside "
           "other pictures"));
    connect(turntable, &QAction::triggered, this, &PictureActions::saveTurntable);
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
    PictureRequest request = m_viewport.pictureRequest();
    request.samples = m_viewport.options().refine ? kShownSamples : 1;
    write(request, sequencePath(folder, baseName(), number, 1));
}

void PictureActions::write(const PictureRequest& request, const QString& path) {
    if (request.samples > 1) {
        const QFileInfo file(path);
        writeSequence({request, 1, file.absolutePath(), file.completeBaseName(), path});
    } else if (Status saved = save(request, path); !saved) {
        Q_EMIT failed(saved.error());
    } else {
        Q_EMIT said(savedText(path));
    }
}

SequenceWriter::Plan PictureActions::turntablePlan() const {
    PictureRequest request = m_viewport.pictureRequest();
    request.width = kTurntableSize.width();
    request.height = kTurntableSize.height();
    request.labels = true;
    request.samples = kShownSamples;
    request.options.shadows = true;
    request.options.sideBySide = false;
    // A box around all that the scene sweeps as it turns, so that nothing leaves the picture.
    const Bounds bounds = m_viewport.session().targets().bounds();
    if (!bounds.empty()) {
        const glm::vec3 half = 0.5f * bounds.size();
        const float around = std::sqrt(half.x * half.x + half.z * half.z);
        const glm::vec3 reach(around, half.y, around);
        Bounds swept;
        swept.add(bounds.centre() - reach);
        swept.add(bounds.centre() + reach);
        request.camera.frame(swept, static_cast<float>(request.width) / static_cast<float>(request.height));
    }
    return {request, kTurntablePictures, {}, baseName() + QStringLiteral("-turntable")};
}

bool PictureActions::makeNewFolder(SequenceWriter::Plan& plan, const QString& parent, const QString& name) {
    const QDir beside(parent);
    QString free = name;
    for (int number = 2; beside.exists(free); ++number) {
        free = QStringLiteral("%1-%2").arg(name, QString::number(number));
    }
    leaveNewFolder();
    plan.folder = beside.filePath(free);
    if (!beside.mkpath(plan.folder)) {
        return false;
    }
    m_newFolder = plan.folder;
    return true;
}

/// It goes where nothing was written into it.
void PictureActions::leaveNewFolder() {
    if (const QString made = std::exchange(m_newFolder, {}); !made.isEmpty()) {
        QDir().rmdir(made);  // which leaves one alone that is not empty
    }
}

void PictureActions::saveTurntable() {
    SequenceWriter::Plan plan = turntablePlan();
    if (makeNewFolder(plan, pictureFolder(), plan.base)) {
        writeSequence(plan);
    } else {
        Q_EMIT failed({"The folder for the turntable cannot be made.", plan.folder.toStdString(),
                       "File > Save Picture As writes elsewhere, and later turntables beside it."});
    }
}

PictureRequest PictureActions::requestOf(const PictureDialog& dialog) const {
    PictureRequest request = m_viewport.pictureRequest();
    request.width = dialog.pictureSize().width();
    request.height = dialog.pictureSize().height();
    request.options.transparent = dialog.isTransparent();
    request.options.floor = dialog.hasFloor();
    request.labels = dialog.hasLabels();
    request.samples = dialog.samples();
    request.selectionMarks = dialog.hasSelectionMarks();
    return request;
}

void PictureActions::choosePicture() {
    const PictureRequest shown = m_viewport.pictureRequest();
    PictureDialog dialog(PictureDialog::Kind::Picture, {shown.width, shown.height}, 0, &m_window);
    dialog.load(QSettings());
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    dialog.save(*ChangedSettings());
    const QStringList suffixes = pictureSuffixes();
    QStringList filters;
    for (const QString& suffix : suffixes) {
        filters << tr("%1 (*.%2)", "PNG (*.png)").arg(suffix.toUpper(), suffix);
    }
    const QString path = askSaveName(
        &m_window, {.title = tr("Save Picture"),
                    .suggested = QDir(existingFolder()).filePath(baseName() + QStringLiteral(".png")),
                    .filters = filters,
                    .suffixes = suffixes});
    if (path.isEmpty()) {
        return;
    }
    rememberFolder(QFileInfo(path).absolutePath());
    write(requestOf(dialog), path);
}

void PictureActions::chooseSequence() {
    const PictureRequest shown = m_viewport.pictureRequest();
    const Session& session = m_viewport.session();
    PictureDialog dialog(PictureDialog::Kind::Sequence, {shown.width, shown.height},
                         session.hits().history().size() - session.hits().disabled(), &m_window);
    dialog.load(QSettings());
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    dialog.save(*ChangedSettings());
    const QString folder =
        QFileDialog::getExistingDirectory(&m_window, tr("Choose Where to Put the Folder"), existingFolder());
    if (folder.isEmpty()) {
        return;
    }
    rememberFolder(folder);
    SequenceWriter::Plan plan{requestOf(dialog), dialog.turntable(), {}, baseName()};
    if (makeNewFolder(plan, folder, plan.base + QStringLiteral("-sequence"))) {
        writeSequence(plan);
    } else {
        Q_EMIT failed({"The folder for the pictures cannot be made.", plan.folder.toStdString(),
                       "Choose a folder that you may write to."});
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

void PictureActions::showProgress(int done, int count) {
    if (!m_progress) {
        return;
    }
    const double fraction = static_cast<double>(done) / count;
    const int pictures = m_sequences.count();
    const int current = std::min(pictures, 1 + static_cast<int>(fraction * pictures));
    const QString what =
        pictures == 1 ? tr("Drawing the picture") : tr("Drawing picture %1 of %2").arg(current).arg(pictures);
    m_progress->setLabelText(
        withRemaining(what, fraction, 1.0e-3 * static_cast<double>(m_progressTime.elapsed())));
    m_progress->setMaximum(count);
    m_progress->setValue(done);  // last: it handles events, and the dialog may go with them
}

void PictureActions::writeSequence(const SequenceWriter::Plan& plan) {
    if (Status started = m_sequences.start(plan); !started) {
        leaveNewFolder();
        Q_EMIT failed(started.error());
        return;
    }
    endProgress();
    m_progressTime.start();
    m_progress = new QProgressDialog(tr("Drawing pictures"), tr("Cancel"), 0, 0, &m_window);
    m_progress->setWindowTitle(tr("Save Pictures"));
    m_progress->setObjectName(QStringLiteral("sequenceProgress"));
    m_progress->setWindowModality(Qt::WindowModal);
    m_progress->setAutoReset(false);
    m_progress->setAutoClose(false);
    connect(m_progress, &QProgressDialog::canceled, &m_sequences, &SequenceWriter::cancel);
    m_progress->show();
}

}  // namespace hitscope
