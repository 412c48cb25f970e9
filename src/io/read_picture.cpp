// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_picture.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QImageReader>
#include <cstring>

#include "io/file_scope.h"
#include "io/picture_format.h"

namespace hitscope {

namespace {

constexpr int kMaxSide = 8192;             // pixels
constexpr int kMaxDecodedMegabytes = 600;  // 8192 x 8192 at 64 bits a pixel, and a little

Error noPicture(const QString& path, const QString& why) {
    return Error{"This file cannot be used as a texture: " + why.toStdString() + ".",
                 QDir::toNativeSeparators(path).toStdString(), "Choose a PNG or JPEG picture."};
}

}  // namespace

Result<Image> readPicture(const QString& path) {
    if (QFileInfo(path).size() > kMaxTextureBytes) {
        return noPicture(path, QStringLiteral("it is too large"));
    }
    QImageReader::setAllocationLimit(kMaxDecodedMegabytes);
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return noPicture(path, file.errorString());
    }
    const QByteArray format = pictureFormat(file);
    QImageReader reader(&file, format);
    const QSize size = reader.size();
    if (size.width() > kMaxSide || size.height() > kMaxSide) {
        return noPicture(path, QStringLiteral("it is larger than %1 x %1 pixels").arg(kMaxSide));
    }
    const bool isVector = format.startsWith("svg") || format == "pdf";  // these could name further files
    const QImage decoded = isVector ? QImage() : reader.read();
    if (decoded.isNull() || decoded.width() > kMaxSide || decoded.height() > kMaxSide) {
        return noPicture(path,
                         isVector ? QStringLiteral("it is no picture of pixels") : reader.errorString());
    }
    const QImage rgba = decoded.convertToFormat(QImage::Format_RGBA8888);
    Image image{rgba.width(), rgba.height(), {}};
    const std::size_t row = 4 * static_cast<std::size_t>(image.width);
    image.pixels.resize(row * static_cast<std::size_t>(image.height));
    for (int y = 0; y < image.height; ++y) {
        std::memcpy(image.pixels.data() + row * static_cast<std::size_t>(y), rgba.constScanLine(y), row);
    }
    return image;
}

}  // namespace hitscope
