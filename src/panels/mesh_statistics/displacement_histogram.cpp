// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/mesh_statistics/displacement_histogram.h"

#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "models/quantity_text.h"
#include "panels/help/help_text.h"
#include "panels/histogram/histogram_plot.h"
#include "session/shown_number.h"
#include "session/vertex_selection.h"

namespace hitscope {

DisplacementHistogram::DisplacementHistogram(Session& session, const MeshMeasuring& measuring,
                                             const Widgets& widgets)
    : m_session(session), m_measuring(measuring), m_widgets(widgets) {
    m_widgets.plot.setLabels(tr("displacement (m)"), tr("vertices"));
    m_widgets.plot.setEmptyText(tr("Nothing has moved yet"));
    connect(&measuring, &MeshMeasuring::measured, this, &DisplacementHistogram::follow);
    connect(&measuring, &MeshMeasuring::upToDateChanged, this, &DisplacementHistogram::follow);
    connect(&session, &Session::sceneReplaced, this, [this] {
        m_isChosen = false;
        follow();
    });
    connect(&m_widgets.plot, &HistogramPlot::rangeDragged, this, [this](double low, double high) {
        m_isChosen = true;
        showBetween(low, high);
    });
    connect(&m_widgets.plot, &HistogramPlot::rangeChosen, this, &DisplacementHistogram::select);
    connect(&m_widgets.select, &QPushButton::clicked, this, &DisplacementHistogram::select);
    connect(&m_widgets.whole, &QPushButton::clicked, this, &DisplacementHistogram::reset);
    follow();
}

void DisplacementHistogram::follow() {
    const std::shared_ptr<const MeshMeasurement>& measurement = m_measuring.measurement();
    const Histogram histogram = measurement ? measurement->histogram : Histogram();
    HistogramPlot& plot = m_widgets.plot;
    plot.setHistogram(histogram);
    const bool isAny = !histogram.counts.empty();
    if (!isAny) {
        m_isChosen = false;  // of what is no longer there
        plot.setRange({});
    } else if (!m_isChosen || !plot.range()) {
        plot.setRange(HistogramPlot::Range{histogram.low, histogram.high});
    }
    const QString none = QObject::tr("No vertex has moved yet.");
    enableIf(m_widgets.select, isAny, none);
    enableIf(m_widgets.whole, isAny, none);
    if (isAny) {
        showBetween(plot.range()->low, plot.range()->high);
    } else {
        m_widgets.between.setText(m_measuring.isUpToDate() ? QString() : tr("Updating…"));
    }
}

std::size_t DisplacementHistogram::countBetween(double low, double high) const {
    std::size_t count = 0;
    if (const auto& measurement = m_measuring.measurement()) {
        for (const auto& entry : measurement->displacements) {
            count += entry.second->within(low, high).size();
        }
    }
    return count;
}

void DisplacementHistogram::showBetween(double low, double high) {
    QString text = tr("%Ln {vertex|vertices} moved %1 to %2 m", nullptr, trCount(countBetween(low, high)))
                       .arg(quantityText(low), quantityText(high));
    if (!m_measuring.isUpToDate()) {
        text += u' ' + tr("(updating…)");
    }
    m_widgets.between.setText(text);
}

void DisplacementHistogram::select() {
    const std::shared_ptr<const MeshMeasurement>& measurement = m_measuring.measurement();
    const std::optional<HistogramPlot::Range>& range = m_widgets.plot.range();
    if (!measurement || !range) {
        return;
    }
    auto combine = VertexSelection::Combine::Replace;
    for (const auto& entry : measurement->displacements) {
        const std::span<const std::uint32_t> within = entry.second->within(range->low, range->high);
        m_session.selection().select(entry.first, {within.begin(), within.end()}, combine);
        combine = VertexSelection::Combine::Add;
    }
    showBetween(range->low, range->high);
}

void DisplacementHistogram::reset() {
    m_isChosen = false;
    m_session.selection().clear();
    follow();
}

}  // namespace hitscope
