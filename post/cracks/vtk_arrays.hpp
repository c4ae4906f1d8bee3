// Arrays of VTK from those of a specimen or a run. Included by the files that write VTK only.
#pragma once

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace graincrack {

/// A named array of n tuples, filled tuple by tuple through `fill(i, values)`.
template <class Array, class Fill>
vtkSmartPointer<Array> make_array(const char* name, int components, std::size_t n, const Fill& fill) {
    auto array = vtkSmartPointer<Array>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(n));
    for (std::size_t i = 0; i < n; ++i) fill(i, array->GetPointer(static_cast<vtkIdType>(i) * components));
    return array;
}

/// The array with its unit, as ParaView shows it.
template <class Array>
vtkSmartPointer<Array> with_unit(vtkSmartPointer<Array> array, const char* unit) {
    array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), unit);
    return array;
}

/// A 3-vector for every node from a plane one.
template <class Array = vtkDoubleArray>
vtkSmartPointer<Array> vectors(const char* name, const std::vector<std::array<double, 2>>& plane) {
    return make_array<Array>(name, 3, plane.size(), [&](std::size_t i, auto* v) {
        using Value = std::remove_pointer_t<decltype(v)>;
        v[0] = static_cast<Value>(plane[i][0]);
        v[1] = static_cast<Value>(plane[i][1]);
        v[2] = 0;
    });
}

template <class Array, class T>
vtkSmartPointer<Array> scalars(const char* name, const std::vector<T>& values) {
    return make_array<Array>(name, 1, values.size(), [&](std::size_t i, auto* v) { *v = values[i]; });
}

/// Texts as field data.
inline void add_texts(vtkDataObject* data, const char* name, const std::vector<std::string>& texts) {
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    for (const std::string& text : texts) array->InsertNextValue(text);
    data->GetFieldData()->AddArray(array);
}

}  // namespace graincrack
