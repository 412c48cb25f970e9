// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/undo_history/undo_history_panel.h"

#include <QStyledItemDelegate>

#include "models/undo_model.h"
#include "session/session.h"
#include "ui_undo_history.h"

namespace hitscope {

namespace {

/// Greys what is undone.
class StepDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        if (!index.data(UndoModel::DoneRole).toBool()) {
            option->palette.setColor(QPalette::Text,
                                     option->palette.color(QPalette::Disabled, QPalette::Text));
        }
    }
};

}  // namespace

UndoHistoryPanel::UndoHistoryPanel(Session& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_model(new UndoModel(session, this)),
      m_ui(std::make_unique<Ui::UndoHistory>()) {
    m_ui->setupUi(this);
    m_ui->steps->setModel(m_model);
    m_ui->steps->setItemDelegate(new StepDelegate(m_ui->steps));
    connect(m_model, &UndoModel::currentChanged, this, &UndoHistoryPanel::follow);
    const auto go = [this](const QModelIndex& index) {
        m_session.goToStep(static_cast<std::size_t>(index.row()));
    };
    connect(m_ui->steps, &QListView::clicked, this, go);
    connect(m_ui->steps, &QListView::activated, this, go);
    follow();
}

UndoHistoryPanel::~UndoHistoryPanel() = default;

void UndoHistoryPanel::follow() {
    const QModelIndex current = m_model->index(m_model->current());
    m_ui->steps->setCurrentIndex(current);
    m_ui->steps->scrollTo(current);
    m_ui->summary->setText(m_model->summary());
}

}  // namespace hitscope
