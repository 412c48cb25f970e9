// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QWidget>
#include <memory>
#include <optional>

#include "models/section_report.h"

class QCPCurve;
class QCPItemLine;
class QCPItemText;
class QCPItemTracer;
class QCustomPlot;

namespace hitscope {

/// A section laid out flat: original and deformed in metres, both axes at the same scale, as one sees it from
/// the open side. Its deepest place is marked; under the cursor it says what is there. Drag and wheel look
/// closer, a double click shows all again.
class SectionPlot : public QWidget {
    Q_OBJECT
public:
    explicit SectionPlot(QWidget* parent = nullptr);

    /// Null: nothing is cut. `room`: what is to be seen of it, in the coordinates of the section's view; it
    /// stays while the plane moves, so that sizes can be compared.
    void setSection(std::shared_ptr<const SceneSection> section, const SectionScope& scope,
                    const QRectF& room);
    void setShown(bool original, bool deformed);
    /// What the cursor at a place of this widget points at; nothing far from any line.
    [[nodiscard]] std::optional<SectionReading> readingAt(const QPointF& position) const;
    /// Where a place of the section falls in this widget.
    [[nodiscard]] QPointF pixelOf(const glm::vec3& place) const;
    void showAll();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void drawCurves();
    void markDeepest();
    [[nodiscard]] QString textOf(const SectionReading& reading) const;
    void followCursor(const QPointF& position);
    void applyPalette();
    void fit();

    QCustomPlot* m_plot;
    QCPCurve* m_original;
    QCPCurve* m_deformed;
    QCPItemLine* m_deepest;
    QCPItemText* m_deepestText;
    QCPItemLine* m_pointed;  ///< from the line under the cursor to the original
    QCPItemTracer* m_cursor;
    QCPItemText* m_note;
    std::shared_ptr<const SceneSection> m_section;
    SectionScope m_scope;
    SectionView m_view;
    QRectF m_room;
    bool m_isMoved = false;  ///< somebody looks closer
};

}  // namespace hitscope
