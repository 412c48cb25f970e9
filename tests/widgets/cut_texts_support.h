// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QTranslator>

class QWidget;

namespace hitscope {

/// The texts below `top`, itself included, that are on the screen and do not fit where they stand: labels,
/// buttons, boxes, tabs, headers, and what columns of tables show. A line each: class, object name, text.
/// What can be reached by a scroll bar is not cut.
[[nodiscard]] QStringList cutTexts(const QWidget& top);

/// Another language, as far as room is concerned: each text is 40 % longer, in words of usual length.
class LongerWords : public QTranslator {
public:
    using QTranslator::QTranslator;
    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char* context, const char* text, const char* comment,
                                    int number) const override;
};

}  // namespace hitscope
