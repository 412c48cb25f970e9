// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/catch_up.h"

#include <utility>

namespace hitscope {

CatchUp::CatchUp(QObject* parent) : QObject(parent) {
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &CatchUp::beginSlice);
}

void CatchUp::pictureShown() {
    m_hasPicture = m_hasPicture || m_isPictureWanted;
    m_isPictureWanted = false;
    m_isAfterPicture = true;
    m_sincePicture.start();
}

/// A turn of the event loop draws, then sees to timers and only then to keys and clicks.
void CatchUp::beginSlice() {
    if (std::exchange(m_isAfterPicture, false)) {
        m_timer.start();
        return;
    }
    Q_EMIT sliceDue();
}

bool CatchUp::isPictureDue(bool isMoving) const {
    return m_isPictureWanted && (isMoving || !m_hasPicture || m_sincePicture.elapsed() >= kBetweenPictures);
}

}  // namespace hitscope
