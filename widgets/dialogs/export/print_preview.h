/// \file
/// A prepared print: its picture, and beside it what is to be known before it is printed.
#pragma once

#include "core/print/print_options.h"
#include "core/print/print_tree.h"
#include <QWidget>
#include <memory>
#include <vector>

class QGridLayout;
class QLabel;
class QPushButton;

namespace ramure {

class PrintView;

inline constexpr double mmPerMetre = 1000.0; ///< the fields have mm

class PrintPreview : public QWidget
{
    Q_OBJECT
public:
    explicit PrintPreview(QWidget* parent = nullptr);

    /// \param print null: nothing is known. \param asked for
    void setPrint(std::shared_ptr<const PrintedTree> print, const PrintOptions& asked);
    [[nodiscard]] PrintView* view() const { return m_view; }
    /// "Name: value" of each line, for whoever reads it aloud or copies it.
    [[nodiscard]] QString text() const;

private:
    enum Row { Size, Scale, Volume, Thinnest, Overhang, Balance, Pieces, Triangles, Branches, Leaves, Rows };
    void build();
    [[nodiscard]] QWidget* legend(const char* name, QLabel*& text);
    void setTexts();
    void fill();
    void setRow(Row row, const QString& value, bool isProblem = false);

    std::shared_ptr<const PrintedTree> m_print;
    PrintOptions m_asked;
    PrintView* m_view;
    QLabel* m_names[Rows];
    QLabel* m_values[Rows];
    QPushButton* m_show; ///< flies to the thinnest place
    QPushButton* m_whole;
    QLabel *m_overhangs = nullptr, *m_ring = nullptr; ///< of the legend
};

} // namespace ramure
