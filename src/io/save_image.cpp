// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/save_image.h"

#include <QBuffer>
#include <QImage>
#include <algorithm>

#include "io/export_files.h"

namespace hitscope {

QByteArray encodePng(const Image& image) {
    const std::size_t expected = 4 * static_cast<std::size_t>(std::max(image.width, 0)) *
                                 static_cast<std::size_t>(std::max(image.height, 0));
    QByteArray png;
    if (!image.empty() && image.pixels.size() == expected) {
        const QImage view(image.pixels.data(), image.width, image.height, 4 * qsizetype{image.width},
                          QImage::Format_RGBA8888);
        QBuffer buffer(&png);
        buffer.open(QIODevice::WriteOnly);
        view.save(&buffer, "png");
    }
    return png;
}

Status savePng(const Image& image, const QString& path) {
    const QByteArray png = encodePng(image);
    if (png.isEmpty()) {
        return Error{"There is no picture to save.", path.toStdString(), {}};
    }
    return writeWhole(path, {png.constData(), static_cast<std::size_t>(png.size())});
}

}  // namespace hitscope
