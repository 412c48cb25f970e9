// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_picture.h"

#include <QDir>
#include <QFile>

#include "io/decode_picture.h"
#include "io/file_scope.h"

namespace hitscope {

namespace {

Error noPicture(const QString& path, const QString& why) {
    return Error{"This file cannot be used as a texture: " + why.toStdString() + ".",
                 QDir::toNativeSeparators(path).toStdString(), "Choose a PNG or JPEG picture."};
}

}  // namespace

Result<Image> readPicture(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return noPicture(path, file.errorString());
    }
    if (file.size() > kMaxTextureBytes) {
        return noPicture(path, QStringLiteral("it is too large"));
    }
    QString why;
    const QImage decoded = decodePicture(file.readAll(), why);
    return decoded.isNull() ? Result<Image>(noPicture(path, why)) : imageOf(decoded);
}

}  // namespace hitscope
