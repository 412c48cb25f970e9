// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/catch_up.h"

namespace hitscope {

CatchUp::CatchUp(QObject* parent) : QObject(parent) {
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &CatchUp::sliceDue);
}

void CatchUp::pictureShown() {
    m_hasPicture = m_hasPicture || m_hasSlice;
    m_hasSlice = false;
    m_sincePicture.start();
}

bool CatchUp::isPictureDue(bool isMoving) const {
    return m_hasSlice && (isMoving || !m_hasPicture || m_sincePicture.elapsed() >= kBetweenPictures);
}

}  // namespace hitscope
