// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/save_image.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>
#include <QImageWriter>
#include <algorithm>

#include "io/staged_files.h"

namespace hitscope {
namespace {

struct Format {
    const char* suffix;
    bool isTransparent;  ///< or can be
};

/// As far as Qt can write them here.
constexpr Format kFormats[] = {{"png", true}, {"jpg", false}, {"jpeg", false}, {"webp", true},
                               {"tif", true}, {"tiff", true}, {"bmp", false},  {"ppm", false}};
constexpr int kQuality = 95;  // per cent, of JPEG; 100 for WebP is without losses

const Format* formatOf(const QString& path) {
    const QByteArray suffix = QFileInfo(path).suffix().toLower().toLatin1();
    const auto* const found =
        std::find_if(std::begin(kFormats), std::end(kFormats), [&suffix](const Format& format) {
            return suffix == format.suffix && QImageWriter::supportedImageFormats().contains(suffix);
        });
    return found != std::end(kFormats) ? found : nullptr;
}

/// Devices and pipes have no suffixes.
bool isDevice(const QString& path) {
    const QFileInfo info(path);
    return info.exists() && !info.isFile() && !info.isDir();
}

bool isOpaque(const Image& image) {
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
        if (image.pixels[i] != 255) {
            return false;
        }
    }
    return true;
}

QByteArray encode(const Image& image, const char* format) {
    const std::size_t expected = 4 * static_cast<std::size_t>(std::max(image.width, 0)) *
                                 static_cast<std::size_t>(std::max(image.height, 0));
    QByteArray bytes;
    if (!image.empty() && image.pixels.size() == expected) {
        QImage view(image.pixels.data(), image.width, image.height, 4 * qsizetype{image.width},
                    QImage::Format_RGBA8888);
        for (const auto& [key, text] : image.notes) {
            view.setText(QString::fromStdString(key), QString::fromStdString(text));
        }
        const bool isPng = std::string_view(format) == "png";
        const bool isWebp = std::string_view(format) == "webp";
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        view.save(&buffer, format, isPng ? -1 : isWebp ? 100 : kQuality);
    }
    return bytes;
}

}  // namespace

QByteArray encodePng(const Image& image) {
    return encode(image, "png");
}

QStringList pictureSuffixes() {
    QStringList suffixes;
    const QList<QByteArray> here = QImageWriter::supportedImageFormats();
    for (const Format& format : kFormats) {
        if (here.contains(format.suffix)) {
            suffixes << QString::fromLatin1(format.suffix);
        }
    }
    return suffixes;
}

Status checkPictureName(const QString& path) {
    if (formatOf(path) != nullptr || isDevice(path)) {
        return Done{};
    }
    const QString suffix = QFileInfo(path).suffix();
    return Error{suffix.isEmpty()
                     ? std::string("The picture's name has no suffix that tells its format.")
                     : "Hitscope cannot write pictures of the format ." + suffix.toStdString() + ".",
                 path.toStdString(),
                 "It writes ." + pictureSuffixes().join(QStringLiteral(", .")).toStdString() + "."};
}

Status savePicture(const Image& image, const QString& path) {
    if (const Status known = checkPictureName(path); !known) {
        return known;
    }
    const Format* const format = formatOf(path);
    if (format != nullptr && !format->isTransparent && !isOpaque(image)) {
        return Error{std::string("Pictures of the format .") + format->suffix + " cannot be transparent.",
                     path.toStdString(), "Save a .png, or give the picture its background."};
    }
    const QByteArray bytes = encode(image, format != nullptr ? format->suffix : "png");
    if (bytes.isEmpty()) {
        return Error{"There is no picture to save.", path.toStdString(), {}};
    }
    return writeWhole(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}  // namespace hitscope
