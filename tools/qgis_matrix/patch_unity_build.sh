#!/bin/bash
# patch_unity_build.sh SOURCE: keeps apart what meets in a unity build of QGIS 3.40 on Qt 6; may run again.
set -euo pipefail
SOURCE=$1/src

# Names that stand in several files: each gets its file's name in front
rename_in() {
    file=$1 own=unity_$(basename "$1" .cpp)
    shift
    for name in "$@"; do
        grep -q "${own}_$name" "$file" || sed -i "s/\b$name\b/${own}_$name/g" "$file"
    done
}

# The same by the preprocessor, where texts hold the name, too
define_in() {
    file=$1 own=unity_$(basename "$1" .cpp) defined='' undefined=''
    shift
    ! grep -q "unity build" "$file" || return 0
    last=$(grep -n '^#include' "$file" | tail -1 | cut -d: -f1)
    for name in "$@"; do
        defined="$defined#define $name ${own}_$name\n"
        undefined="$undefined#undef $name\n"
    done
    sed -i "${last}a // unity build\n$defined" "$file"
    printf '%b' "$undefined" >>"$file"
}

cd "$SOURCE/core"
sed -i 's/\^ qHash( request.attributes().toFields() )/^ qHash( request.attributes().toFields().size() )/' \
    pointcloud/qgspointcloudrequest.cpp
rename_in mesh/qgsmeshadvancedediting.cpp vertexPositionInFace
rename_in mesh/qgsmeshforcebypolylines.cpp vertexPositionInFace
rename_in qgsgmlschema.cpp NS_SEPARATOR
rename_in geocoding/qgsgooglemapsgeocoder.cpp sCachedResults
for file in numericformats/qgs{basic,coordinate,fraction}numericformat.cpp; do
    rename_in "$file" formatter
done
grep -q "define QGSSENSORTHINGSCONNECTION_H" providers/sensorthings/qgssensorthingsconnection.h ||
    sed -i 's/^#ifndef QGSSENSORTHINGSCONNECTION_H/&\n#define QGSSENSORTHINGSCONNECTION_H/' \
        providers/sensorthings/qgssensorthingsconnection.h

cd "$SOURCE/analysis/processing"
for file in qgsalgorithm{zonalstatistics,extractzmvalues,zonalstatisticsfeaturebased}.cpp; do
    rename_in "$file" STATS
done
rename_in qgsalgorithmalignsingleraster.cpp QgsAlignRasterProgress
define_in qgsalgorithmrandompointsonlines.cpp INPUT POINTS_NUMBER MIN_DISTANCE_GLOBAL MIN_DISTANCE MAX_TRIES_PER_POINT \
    SEED OUTPUT OUTPUT_POINTS POINTS_MISSED POINTS_MISSED_GLOBAL LINES_WITH_MISSED_POINTS \
    FEATURES_WITH_EMPTY_OR_NO_GEOMETRY INCLUDE_LINE_ATTRIBUTES

cd "$SOURCE/gui/auth"
for file in $(grep -lE "setItemBold_|removeChildren_" ./*.cpp); do
    rename_in "$file" setItemBold_ removeChildren_
done

cd "$SOURCE"
for file in core/tiledscene/qgsgltfutils.cpp analysis/processing/qgsalgorithmb3dmtogltf.cpp; do
    grep -q "undef TINYGLTF_IMPLEMENTATION" "$file" || sed -i '/#include.*tiny_gltf.h/a \
#undef TINYGLTF_IMPLEMENTATION\n#undef STB_IMAGE_IMPLEMENTATION\n#undef STB_IMAGE_WRITE_IMPLEMENTATION' "$file"
done
grep -q "pragma once" app/dwg/qgsdwgimporter.h || sed -i '1i #pragma once' app/dwg/qgsdwgimporter.h

# Targets that stay apart as a whole: Python.h beside Qt's slots, the WMS provider, the binding of gui
alone() {
    grep -q "$2 PROPERTIES UNITY_BUILD OFF" "$1/CMakeLists.txt" ||
        echo "set_target_properties($2 PROPERTIES UNITY_BUILD OFF)" >>"$1/CMakeLists.txt"
}
alone python qgispython
alone providers/wms provider_wms_a
alone providers/wms provider_wms_gui_a
grep -q "TARGET provider_wms)" providers/wms/CMakeLists.txt ||
    printf 'if(TARGET provider_wms)\n  set_property(TARGET provider_wms PROPERTY UNITY_BUILD OFF)\nendif()\n' \
        >>providers/wms/CMakeLists.txt
grep -q "UNITY_BUILD OFF" ../cmake/SIPMacros.cmake || sed -i \
    '/ADD_LIBRARY(${_logical_name} MODULE ${_sip_output_files} ${EXTRA_OBJECTS})/a \  if("${_logical_name}" MATCHES "gui")\n    set_target_properties(${_logical_name} PROPERTIES UNITY_BUILD OFF)\n  endif()' \
    ../cmake/SIPMacros.cmake
