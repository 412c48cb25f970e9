// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QIODevice>
#include <QImageReader>

namespace hitscope {

/// The format of a picture as QImageReader names it, by its content, which is read from the start; empty: it
/// is none that Qt's plugins read. The device can be read anywhere and is at its start afterwards.
inline QByteArray pictureFormat(QIODevice& device) {
    device.seek(0);
    QImageReader any(&device);
    QByteArray format = any.canRead() ? any.format().toLower() : QByteArray();
    device.seek(0);
    // TGA begins with no mark of its own, and Qt takes it for WBMP.
    if (format.isEmpty() || format == "wbmp") {
        format = QImageReader(&device, "tga").canRead() ? QByteArrayLiteral("tga") : format;
        device.seek(0);
    }
    return format;
}

}  // namespace hitscope
