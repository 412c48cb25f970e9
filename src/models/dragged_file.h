// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMimeData>
#include <QString>
#include <functional>

namespace hitscope {

/// Something that is dragged out of the window and becomes a file where it is dropped. It is written when the
/// other program asks for it, into a folder that lasts as long as this program.
class DraggedFile : public QMimeData {
    Q_OBJECT
public:
    /// Writes the file; false: it could not.
    using Write = std::function<bool(const QString& path)>;
    /// name: without a folder, "hits.csv". `text`: the same as text, also made when it is asked for; may be
    /// empty.
    DraggedFile(QString name, Write write, std::function<QString()> text = {});

    [[nodiscard]] const QString& name() const { return m_name; }
    [[nodiscard]] QStringList formats() const override;
    [[nodiscard]] bool hasFormat(const QString& type) const override;

protected:
    [[nodiscard]] QVariant retrieveData(const QString& type, QMetaType preferred) const override;

private:
    QString m_name;
    Write m_write;
    std::function<QString()> m_text;
    mutable QString m_path;  // empty: not written yet
};

}  // namespace hitscope
