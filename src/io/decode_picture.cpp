// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/decode_picture.h"

#include <stb_image.h>

#include <QBuffer>
#include <QImageReader>
#include <cstring>
#include <memory>

namespace hitscope {

namespace {

constexpr int kMaxSide = 8192;             // pixels
constexpr int kMaxDecodedMegabytes = 600;  // 8192 x 8192 at 64 bits a pixel, and a little

bool isOfPixels(const QByteArray& format) {
    static const QList<QByteArray> known{"png", "jpg",  "jpeg", "bmp", "gif",
                                         "tif", "tiff", "webp", "ppm", "pgm"};
    return known.contains(format);
}

QString tooLarge() {
    return QStringLiteral("it is larger than %1 x %1 pixels").arg(kMaxSide);
}

/// TGA begins with no mark: with the length of a name, whether it has a palette, and how its pixels are kept.
bool isTga(const QByteArray& bytes) {
    constexpr qsizetype kHeader = 18;
    if (bytes.size() <= kHeader) {
        return false;
    }
    const auto at = [&bytes](qsizetype place) { return static_cast<unsigned char>(bytes[place]); };
    const int kind = at(2) & ~8;  // 8: run lengths
    const int depth = at(16);
    return at(1) <= 1 && (kind == 1 || kind == 2 || kind == 3) && (at(1) == 1) == (kind == 1) &&
           (depth == 8 || depth == 15 || depth == 16 || depth == 24 || depth == 32);
}

/// By stb, since Qt's plugin reads neither run lengths nor files without a footer.
QImage decodeTga(const QByteArray& bytes, QString& why) {
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.constData());
    const int size = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(data, size, &width, &height, &channels) != 0 &&
        (width > kMaxSide || height > kMaxSide)) {
        why = tooLarge();
        return {};
    }
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(data, size, &width, &height, &channels, 4), &stbi_image_free);
    if (!pixels) {
        why = QStringLiteral("it is a damaged TGA picture");
        return {};
    }
    return QImage(pixels.get(), width, height, 4 * width, QImage::Format_RGBA8888).copy();
}

}  // namespace

QImage decodePicture(const QByteArray& bytes, QString& why) {
    QImageReader::setAllocationLimit(kMaxDecodedMegabytes);
    QBuffer buffer;
    buffer.setData(bytes);
    buffer.open(QIODevice::ReadOnly);
    QImageReader reader(&buffer);
    if (!isOfPixels(reader.format().toLower())) {
        if (isTga(bytes)) {
            return decodeTga(bytes, why);
        }
        why = QStringLiteral("it is not a picture of a known format");
        return {};
    }
    const QSize size = reader.size();
    if (size.width() > kMaxSide || size.height() > kMaxSide) {
        why = tooLarge();
        return {};
    }
    const QImage decoded = reader.read();
    if (decoded.isNull()) {
        why = reader.errorString();
    } else if (decoded.width() > kMaxSide || decoded.height() > kMaxSide) {
        why = tooLarge();
        return {};
    }
    return decoded;
}

Image imageOf(const QImage& picture) {
    const QImage rgba = picture.convertToFormat(QImage::Format_RGBA8888);
    Image image{rgba.width(), rgba.height(), {}};
    const std::size_t row = 4 * static_cast<std::size_t>(image.width);
    image.pixels.resize(row * static_cast<std::size_t>(image.height));
    for (int y = 0; y < image.height; ++y) {
        std::memcpy(image.pixels.data() + row * static_cast<std::size_t>(y), rgba.constScanLine(y), row);
    }
    return image;
}

}  // namespace hitscope
