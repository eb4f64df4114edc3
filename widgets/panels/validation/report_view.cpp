#include "widgets/panels/validation/report_view.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QScrollBar>
#include <algorithm>

namespace ramure {
namespace {

constexpr int leastRows = 7; ///< in sight, below the header: six of them whole

} // namespace

ReportView::ReportView(ReportModel* model, QWidget* parent)
    : QTreeView(parent)
    , m_model(model)
{
    setObjectName(QStringLiteral("reportView"));
    setModel(model);
    setUniformRowHeights(true);
    setIndentation(14);
    setAllColumnsShowFocus(true);
    setFrameShape(QFrame::NoFrame);
    setEditTriggers(NoEditTriggers);
    setTextElideMode(Qt::ElideRight);
    setHorizontalScrollMode(ScrollPerPixel);
    header()->setStretchLastSection(false);
    header()->setResizeContentsPrecision(0); // what is in sight; kinds may have 10,000 rows
    header()->setSectionResizeMode(ReportModel::WhatColumn, QHeaderView::Stretch);
    header()->setSectionResizeMode(ReportModel::BranchColumn, QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(ReportModel::PlaceColumn, QHeaderView::ResizeToContents);
    connect(this, &QTreeView::clicked, this, &ReportView::chosen);
    connect(this, &QTreeView::expanded, this, [this](const QModelIndex& index) {
        if (std::find(m_open.begin(), m_open.end(), m_model->kind(index)) == m_open.end())
            m_open.push_back(m_model->kind(index));
    });
    connect(this, &QTreeView::collapsed, this, [this](const QModelIndex& index) {
        if (!m_reopening)
            std::erase(m_open, m_model->kind(index));
    });
    connect(model, &QAbstractItemModel::modelReset, this, &ReportView::reopen);
    reopen();
}

QSize ReportView::minimumSizeHint() const
{
    const int row = std::max(sizeHintForRow(0), fontMetrics().height());
    const int bars = header()->sizeHint().height() + horizontalScrollBar()->sizeHint().height();
    const int height = bars + leastRows * row + 2 * frameWidth();
    return {QTreeView::minimumSizeHint().width(), height};
}

void ReportView::reopen()
{
    m_reopening = true;
    for (int row = 0; row < m_model->rowCount(); ++row) {
        const QModelIndex top = m_model->index(row, 0);
        setFirstColumnSpanned(row, {}, true);
        if (std::find(m_open.begin(), m_open.end(), m_model->kind(top)) != m_open.end())
            expand(top);
    }
    m_reopening = false;
}

void ReportView::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape) {
        event->accept();
        emit left();
        return;
    }
    const QPersistentModelIndex before = currentIndex();
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    QTreeView::keyPressEvent(event);
    const QModelIndex now = currentIndex();
    if (now.isValid() && (enter || before != now))
        emit chosen(now);
}

} // namespace ramure
