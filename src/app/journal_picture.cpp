// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/journal_picture.h"

#include <QBuffer>
#include <QImage>
#include <algorithm>

#include "document/journal_records.h"
#include "document/session_journal.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

/// The best that fits; empty: nothing does.
QByteArray jpegOf(const QImage& image) {
    for (int quality = 85; quality >= 25; quality -= 20) {
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        if (image.save(&buffer, "JPEG", quality) && static_cast<std::size_t>(buffer.size()) <= kMostPicture) {
            return buffer.data();
        }
    }
    return {};
}

}  // namespace

JournalPicture::JournalPicture(Viewport& viewport, SessionJournal& journal, QObject* parent)
    : QObject(parent), m_viewport(viewport), m_journal(journal) {
    m_still.setSingleShot(true);
    connect(&m_still, &QTimer::timeout, this, &JournalPicture::take);
    connect(&viewport.pictures(), &PictureFlow::framePainted, this, &JournalPicture::wait);
    connect(&journal, &SessionJournal::begun, this, [this] {
        m_sinceLast.invalidate();
        wait();
    });
}

void JournalPicture::wait() {
    if (m_journal.isBegun()) {
        const qint64 passed = m_sinceLast.isValid() ? m_sinceLast.elapsed() : kLeastApart;
        m_still.start(
            std::max(kStill, static_cast<int>(kLeastApart - std::min<qint64>(passed, kLeastApart))));
    }
}

void JournalPicture::take() {
    if (!m_journal.isBegun()) {
        return;
    }
    const QImage picture = m_viewport.pictures().thumbnail(kWidth);
    const QByteArray jpeg = picture.isNull() ? QByteArray() : jpegOf(picture);
    if (!jpeg.isEmpty()) {
        m_journal.writer().setPicture(jpeg);
        m_sinceLast.start();
    }
}

}  // namespace hitscope
