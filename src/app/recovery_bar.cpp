// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery_bar.h"

#include <QBuffer>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QImageReader>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "analysis/beside.h"
#include "app/discard_guard.h"
#include "app/session_files.h"
#include "document/journal_files.h"
#include "document/journal_records.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr int kPictureWidth = 128;     // logical pixels
constexpr int kLargestPicture = 2048;  // pixels a side: larger is none of ours

/// Null where there is none, or none that is ours.
QPixmap pictureOf(const QByteArray& jpeg, double pixelRatio) {
    if (jpeg.isEmpty()) {
        return {};  // Qt would warn of a file that is none
    }
    QBuffer buffer;
    buffer.setData(jpeg);
    QImageReader reader(&buffer, "jpeg");
    const QSize size = reader.size();
    if (size.isEmpty() || std::max(size.width(), size.height()) > kLargestPicture) {
        return {};
    }
    QImage image = reader.read();
    if (image.isNull()) {
        return {};
    }
    const auto width = static_cast<int>(std::lround(kPictureWidth * pixelRatio));
    image = image.scaled(width, 2 * width, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    image.setDevicePixelRatio(pixelRatio);
    return QPixmap::fromImage(image);
}

}  // namespace

/// The other thread holds on to it too.
struct RecoveryBar::Found {
    ClaimedJournal journal;
    QDateTime changed;
    std::optional<RecoveredJournal> read;
};

/// The session's file, but not one that was written after the journal: what is recovered is older, and is not
/// saved over it without a question.
QString RecoveryBar::fileOf(const Found& found) {
    const QFileInfo file(found.read->file);
    const bool isNewer = file.exists() && file.lastModified() > found.changed;
    return found.read->file.isEmpty() || isNewer ? QString() : file.absoluteFilePath();
}

RecoveryBar::RecoveryBar(SessionFiles& files, DiscardGuard& guard, const QString& folder, QWidget* parent)
    : QFrame(parent),
      m_files(files),
      m_guard(guard),
      m_folder(folder),
      m_text(new QLabel(this)),
      m_picture(new QLabel(this)) {
    setObjectName(QStringLiteral("recovery"));
    setFrameShape(QFrame::StyledPanel);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    auto* recover = new QPushButton(tr("&Recover"), this);
    recover->setObjectName(QStringLiteral("recover"));
    recover->setToolTip(tr("Go on with that session; save it to keep it"));
    auto* later = new QPushButton(tr("Later"), this);
    later->setObjectName(QStringLiteral("recoverLater"));
    later->setToolTip(tr("Keep it; the next start offers it again"));
    auto* discard = new QPushButton(tr("Discard…"), this);
    discard->setObjectName(QStringLiteral("discardRecovery"));
    discard->setToolTip(tr("Delete what was kept of that session"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 6, 6, 6);
    m_picture->setObjectName(QStringLiteral("recoveryPicture"));
    m_picture->setAlignment(Qt::AlignTop);
    layout->addWidget(m_picture);
    layout->addSpacing(4);
    layout->addWidget(m_text, 1);
    layout->addWidget(recover, 0, Qt::AlignTop);
    layout->addWidget(later, 0, Qt::AlignTop);
    layout->addWidget(discard, 0, Qt::AlignTop);
    connect(recover, &QPushButton::clicked, this, [this] { m_guard.ask([this] { this->recover(); }); });
    connect(later, &QPushButton::clicked, this, &RecoveryBar::postpone);
    connect(discard, &QPushButton::clicked, this, &RecoveryBar::askToDiscard);
    hide();
}

RecoveryBar::~RecoveryBar() = default;

void RecoveryBar::look() {
    if (m_found || m_isReading) {
        return;
    }
    for (const FoundJournal& journal : findJournals(m_folder)) {
        if (m_passedOver.contains(journal.path)) {
            continue;
        }
        Result<ClaimedJournal> claimed = ClaimedJournal::claim(journal.path);
        if (!claimed) {
            continue;  // another window offers it
        }
        auto found = std::make_shared<Found>(Found{std::move(claimed.value()), journal.changed, {}});
        m_isReading = true;
        workBeside(
            this,
            [found] {
                if (const Result<QByteArray> bytes = found->journal.read()) {
                    if (Result<RecoveredJournal> read = readJournal(bytes.value())) {
                        found->read = std::move(read.value());
                    }
                }
            },
            [found](RecoveryBar& self, bool) { self.take(found); });
        return;
    }
}

void RecoveryBar::take(const std::shared_ptr<Found>& found) {
    m_isReading = false;
    if (!found->read) {
        m_passedOver << found->journal.path();  // it stays where it is, for who can read it
        look();
        return;
    }
    m_found = found;
    const SessionDocument& document = found->read->document;
    const QString when = QLocale().toString(found->changed, QLocale::ShortFormat);
    const QString work = document.hits.empty()
                             ? tr("%Ln {target|targets}", nullptr, trCount(document.targets.size()))
                             : tr("%Ln {hit|hits}", nullptr, trCount(document.hits.size()));
    const QString name =
        found->read->file.isEmpty() ? document.scene.name : QFileInfo(found->read->file).fileName();
    const QString lost =
        found->read->lostLines == 0
            ? QString()
            : u' ' + tr("A part of what was kept of it is damaged: its last changes are lost.");
    m_text->setText(
        tr("Hitscope ended unexpectedly. The session “%1” of %2, with %3, can be recovered, without "
           "its steps to undo.")
            .arg(name, when, work) +
        lost + othersText());
    const QPixmap picture = pictureOf(found->read->picture, devicePixelRatioF());
    m_picture->setPixmap(picture);
    m_picture->setVisible(!picture.isNull());
    show();
}

/// Of those that are offered after this one; empty: there are none.
QString RecoveryBar::othersText() const {
    const std::vector<FoundJournal> journals = findJournals(m_folder);
    const auto others = std::count_if(journals.begin(), journals.end(), [this](const FoundJournal& journal) {
        return !m_passedOver.contains(journal.path);
    });
    return others == 0 ? QString()
                       : u' ' + tr("%Ln more {session comes|sessions come} after it.", nullptr,
                                   trCount(static_cast<std::size_t>(others)));
}

/// Another window may offer it meanwhile.
void RecoveryBar::postpone() {
    if (const std::shared_ptr<Found> found = std::exchange(m_found, nullptr)) {
        m_passedOver << found->journal.path();
    }
    hide();
    look();
}

void RecoveryBar::recover() {
    const std::shared_ptr<Found> found = std::exchange(m_found, nullptr);
    if (!found) {
        return;
    }
    hide();
    m_files.openDocument(
        found->read->document,
        {.file = fileOf(*found),
         .noteInPart = tr("This is a part of the session. All of it is still kept: the next start offers it "
                          "again."),
         .ended = [self = QPointer(this), found](SessionFiles::Ended how) {
             if (self) {
                 self->takeEnded(found, how);
             }
         }});
}

/// The journal stays until the session is kept in another; where it was not opened it is offered again. What
/// was left out is in no other: the next start may find the meshes.
void RecoveryBar::takeEnded(const std::shared_ptr<Found>& found, SessionFiles::Ended how) {
    if (how == SessionFiles::Ended::Whole) {
        m_recovered.push_back(found);
        look();
    } else if (how == SessionFiles::Ended::InPart) {
        m_passedOver << found->journal.path();
        look();
    } else if (!m_found) {
        m_found = found;
        show();
    }
}

void RecoveryBar::dropRecovered() {
    for (const std::shared_ptr<Found>& found : std::exchange(m_recovered, {})) {
        if (found->read->lostLines == 0) {
            static_cast<void>(found->journal.discard());
        } else if (found->journal.setAside()) {
            Q_EMIT noticeWanted(tr("What could not be recovered is kept in %1.").arg(found->journal.path()));
        }
    }
}

void RecoveryBar::askToDiscard() {
    auto* box = new QMessageBox(QMessageBox::Question, tr("Discard Session"),
                                tr("Delete what was kept of this session? This cannot be undone."),
                                QMessageBox::Cancel, window());
    box->setObjectName(QStringLiteral("confirmDiscard"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    const QPushButton* discard = box->addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    box->setDefaultButton(QMessageBox::Cancel);
    connect(discard, &QPushButton::clicked, this, &RecoveryBar::discard);
    box->open();
}

void RecoveryBar::discard() {
    const std::shared_ptr<Found> found = std::exchange(m_found, nullptr);
    hide();
    if (found) {
        if (const Status gone = found->journal.discard(); !gone) {
            m_passedOver << found->journal.path();
            Q_EMIT failed(gone.error());
        }
    }
    look();
}

}  // namespace hitscope
