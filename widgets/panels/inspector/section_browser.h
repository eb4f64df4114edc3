/// \file
/// The cross-sections of one branch: a slider and a field to step through them, the values of the one being
/// looked at, and the table of all.
#pragma once

#include "widgets/panels/inspector/section_model.h"
#include <QTableView>
#include <QWidget>

class QLabel;
class QSlider;
class QToolButton;

namespace ramure {

class FactForm;
class NumberField;

/// A table whose Ctrl+C is its own, whatever the window does with that key.
class SectionTable : public QTableView
{
    Q_OBJECT
public:
    using QTableView::QTableView;

signals:
    void copyRequested();

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
};

class SectionBrowser : public QWidget
{
    Q_OBJECT
public:
    explicit SectionBrowser(QWidget* parent = nullptr);

    /// The section looked at stays as near to the one the user chose as the number of sections allows.
    void setFacts(std::vector<SectionFacts> facts);
    [[nodiscard]] const std::vector<SectionFacts>& facts() const { return m_model->facts(); }
    /// The values of the current section, one below the other: for whoever has a place for them.
    [[nodiscard]] FactForm* details() const { return m_form; }
    /// From 0; -1 where there are no sections.
    [[nodiscard]] int currentSection() const;
    void setAngleUnit(AngleUnit unit);

public slots:
    /// Held to the sections there are.
    void setCurrentSection(int section);
    /// All sections, or the selected rows where there are several.
    void copyCsv(bool selectedRowsOnly);

signals:
    void currentSectionChanged(int section);
    void messageRaised(const QString& text);

private:
    void buildStepper();
    void buildTable();
    void showCurrent();
    void fitColumns();

    SectionModel* m_model = nullptr;
    AngleUnit m_unit = AngleUnit::Degrees;
    int m_chosen = 0; ///< by the user, even where there are fewer sections at the moment
    bool m_showing = false;
    QLabel* m_total = nullptr;
    QSlider* m_slider = nullptr;
    NumberField* m_field = nullptr;
    FactForm* m_form = nullptr;
    SectionTable* m_table = nullptr;
    QToolButton* m_copy = nullptr;
};

} // namespace ramure
