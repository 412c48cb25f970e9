// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/plain_text.h"

#include <QRegularExpression>
#include <QTextDocument>

namespace hitscope {

QString asPlainText(const QString& text) {
    return Qt::mightBeRichText(text)
               ? QStringLiteral("<p style=\"white-space: pre-wrap\">%1</p>").arg(text.toHtmlEscaped())
               : text;
}

/// "&&" stands for an "&".
QString withoutMarks(QString text) {
    static const QRegularExpression mark(QStringLiteral("&(.?)"));
    return text.replace(mark, QStringLiteral("\\1")).remove(QStringLiteral("…"));
}

}  // namespace hitscope
