/// \file
/// The part of the validation panel that tells what the background analysis of a mesh found, how far it is,
/// and lets it be stopped, started again, or followed by moving colliding branches apart.
#pragma once

#include "core/document/analysis.h"
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace ramure {

class HistogramView;

class AnalysisStrip : public QWidget
{
    Q_OBJECT
public:
    /// \param analysis is not owned and must outlive the strip.
    explicit AnalysisStrip(Analysis* analysis, QWidget* parent = nullptr);

    void setTree(NodeId tree);
    void retranslate();

signals:
    /// The button beside the collisions was pressed.
    void separateRequested(ramure::NodeId tree);

private:
    void refresh();
    void showFindings(const MeshAnalysis* findings);
    void showWork(Analysis::State state);
    [[nodiscard]] QString stateText(Analysis::State state) const;

    Analysis* m_analysis;
    NodeId m_tree = noNode;
    QLabel* m_text;
    QLabel* m_shape;
    QLabel* m_hash;
    HistogramView* m_histogram;
    QProgressBar* m_progress;
    QToolButton* m_cancel;
    QPushButton* m_again;
    QPushButton* m_separate;
};

} // namespace ramure
