<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<!-- /*tr*/ marks the texts that are shown in the user's language (toolkit/layer_styles.py), as are the labels of the
     categories. Outlines are polygons without an inside, which QGIS leaves in their own colour when they are selected;
     below them lies the line that it draws in the colour of the selection. -->
<qgis version="3.22.16-Białowieża" styleCategories="Symbology|Labeling|MapTips" labelsEnabled="1">
  <renderer-v2 symbollevels="0" type="categorizedSymbol" forceraster="0" referencescale="-1" enableorderby="1" attr="verdict">
    <categories>
      <category symbol="0" label="significant loss" render="true" value="significant"/>
      <category symbol="1" label="reduced" render="true" value="reduced"/>
      <category symbol="2" label="preserved" render="true" value="preserved"/>
      <category symbol="3" label="not comparable" render="true" value="not_comparable"/>
      <category symbol="4" label="not inspected" render="true" value=""/>
    </categories>
    <symbols>
      <symbol alpha="1" clip_to_extent="1" name="0" type="fill" force_rhr="0">
        <layer pass="0" enabled="1" class="SimpleLine" locked="1">
          <Option type="Map">
            <Option name="capstyle" value="square" type="QString"/>
            <Option name="joinstyle" value="miter" type="QString"/>
            <Option name="line_color" value="255,255,0,0" type="QString"/>
            <Option name="line_style" value="solid" type="QString"/>
            <Option name="line_width" value="3.9" type="QString"/>
            <Option name="line_width_unit" value="MM" type="QString"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" value="" type="QString"/>
              <Option name="properties" type="Map">
                <Option name="enabled" type="Map">
                  <Option name="active" value="true" type="bool"/>
                  <Option name="expression" value="coalesce(map_exist(@seam_inspector_selected, @layer_id || ' ' || $id), false)" type="QString"/>
                  <Option name="type" value="3" type="int"/>
                </Option>
                <Option name="outlineWidth" type="Map">
                  <Option name="active" value="true" type="bool"/>
                  <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 2.5, 3.9), 3.9)" type="QString"/>
                  <Option name="type" value="3" type="int"/>
                </Option>
              </Option>
              <Option name="type" value="collection" type="QString"/>
            </Option>
          </data_defined_properties>
        </layer>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="0">
          <Option type="Map">
            <Option name="SymbolType" value="Fill" type="QString"/>
            <Option name="geometryModifier" value="coalesce(make_polygon(exterior_ring($geometry), exterior_ring($geometry)), $geometry)" type="QString"/>
            <Option name="units" value="MapUnit" type="QString"/>
          </Option>
          <symbol alpha="1" clip_to_extent="1" name="@0@1" type="fill" force_rhr="0">
            <layer pass="0" enabled="1" class="SimpleFill" locked="1">
              <Option type="Map">
                <Option name="color" value="0,0,0,0" type="QString"/>
                <Option name="joinstyle" value="miter" type="QString"/>
                <Option name="outline_color" value="255,255,255,190" type="QString"/>
                <Option name="outline_style" value="solid" type="QString"/>
                <Option name="outline_width" value="1.7" type="QString"/>
                <Option name="outline_width_unit" value="MM" type="QString"/>
                <Option name="style" value="no" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="outlineWidth" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 0.8, 1.7), 1.7)" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
            <layer pass="0" enabled="1" class="SimpleFill" locked="1">
              <Option type="Map">
                <Option name="color" value="0,0,0,0" type="QString"/>
                <Option name="joinstyle" value="miter" type="QString"/>
                <Option name="outline_color" value="0,0,0,255" type="QString"/>
                <Option name="outline_style" value="no" type="QString"/>
                <Option name="outline_width" value="1.7" type="QString"/>
                <Option name="outline_width_unit" value="MM" type="QString"/>
                <Option name="style" value="no" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="outlineStyle" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="if(coalesce(map_exist(@seam_inspector_selected, @layer_id || ' ' || $id), false), 'solid', 'no')" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                    <Option name="outlineWidth" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 0.8, 1.7), 1.7) + 0.5" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
            <layer pass="0" enabled="1" class="SimpleFill" locked="0">
              <Option type="Map">
                <Option name="color" value="213,94,0,255" type="QString"/>
                <Option name="joinstyle" value="miter" type="QString"/>
                <Option name="outline_color" value="213,94,0,255" type="QString"/>
                <Option name="outline_style" value="solid" type="QString"/>
                <Option name="outline_width" value="1.1" type="QString"/>
                <Option name="outline_width_unit" value="MM" type="QString"/>
                <Option name="style" value="no" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="outlineWidth" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 0.5, 1.1), 1.1)" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="1">
          <Option type="Map">
            <Option name="SymbolType" value="Marker" type="QString"/>
            <Option name="geometryModifier" value="with_variable('seen', intersection($geometry, transform(@map_extent, @map_crs, @layer_crs)), make_point(x_max(@seen), y_min(@seen), (240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs)))))" type="QString"/>
            <Option name="units" value="MapUnit" type="QString"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" value="" type="QString"/>
              <Option name="properties" type="Map">
                <Option name="enabled" type="Map">
                  <Option name="active" value="true" type="bool"/>
                  <Option name="expression" value="coalesce(attribute('observer') IN ('visible', 'invisible', 'unsure') AND (240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))) &gt; 3, false)" type="QString"/>
                  <Option name="type" value="3" type="int"/>
                </Option>
              </Option>
              <Option name="type" value="collection" type="QString"/>
            </Option>
          </data_defined_properties>
          <symbol alpha="1" clip_to_extent="1" name="@0@2" type="marker" force_rhr="0">
            <layer pass="0" enabled="1" class="SvgMarker" locked="0" userFlags="DisableSelectionRecoloring">
              <Option type="Map">
                <Option name="name" value="base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiMyMDIwMjAiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTQuNSAxMiBRMTIgMy41IDE5LjUgMTIgUTEyIDIwLjUgNC41IDEyIFoiIGZpbGw9Im5vbmUiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMi43IiBmaWxsPSIjZmZmZmZmIi8+PC9zdmc+" type="QString"/>
                <Option name="size" value="4" type="QString"/>
                <Option name="size_unit" value="MM" type="QString"/>
                <Option name="horizontal_anchor_point" value="2" type="QString"/>
                <Option name="vertical_anchor_point" value="2" type="QString"/>
                <Option name="offset" value="-0.6,-0.6" type="QString"/>
                <Option name="offset_unit" value="MM" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="name" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="CASE WHEN &quot;observer&quot; = 'visible' THEN 'base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiMyMDIwMjAiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTQuNSAxMiBRMTIgMy41IDE5LjUgMTIgUTEyIDIwLjUgNC41IDEyIFoiIGZpbGw9Im5vbmUiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMi43IiBmaWxsPSIjZmZmZmZmIi8+PC9zdmc+' WHEN &quot;observer&quot; = 'invisible' THEN 'base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiNmZmZmZmYiIHN0cm9rZT0iIzIwMjAyMCIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTQuNSAxMiBRMTIgMy41IDE5LjUgMTIgUTEyIDIwLjUgNC41IDEyIFoiIGZpbGw9Im5vbmUiIHN0cm9rZT0iIzIwMjAyMCIgc3Ryb2tlLXdpZHRoPSIyIi8+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMi43IiBmaWxsPSIjMjAyMDIwIi8+PHBhdGggZD0iTTYgMTguNSBMMTggNS41IiBzdHJva2U9IiMyMDIwMjAiIHN0cm9rZS13aWR0aD0iMi40Ii8+PC9zdmc+' WHEN &quot;observer&quot; = 'unsure' THEN 'base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiNmZmZmZmYiIHN0cm9rZT0iIzIwMjAyMCIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTguMiA5LjUgUTguMiA1LjggMTIgNS44IFExNS44IDUuOCAxNS44IDkuMiBRMTUuOCAxMS40IDEzLjYgMTIuNCBRMTIgMTMuMiAxMiAxNSIgZmlsbD0ibm9uZSIgc3Ryb2tlPSIjMjAyMDIwIiBzdHJva2Utd2lkdGg9IjIuNiIvPjxjaXJjbGUgY3g9IjEyIiBjeT0iMTguNCIgcj0iMS43IiBmaWxsPSIjMjAyMDIwIi8+PC9zdmc+' END" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                    <Option name="size" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear(z($geometry), 3, 14, 2, 4.5), 0)" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
      </symbol>
      <symbol alpha="1" clip_to_extent="1" name="1" type="fill" force_rhr="0">
        <layer pass="0" enabled="1" class="SimpleLine" locked="1">
          <Option type="Map">
            <Option name="capstyle" value="square" type="QString"/>
            <Option name="joinstyle" value="miter" type="QString"/>
            <Option name="line_color" value="255,255,0,0" type="QString"/>
            <Option name="line_style" value="solid" type="QString"/>
            <Option name="line_width" value="3.6" type="QString"/>
            <Option name="line_width_unit" value="MM" type="QString"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" value="" type="QString"/>
              <Option name="properties" type="Map">
                <Option name="enabled" type="Map">
                  <Option name="active" value="true" type="bool"/>
                  <Option name="expression" value="coalesce(map_exist(@seam_inspector_selected, @layer_id || ' ' || $id), false)" type="QString"/>
                  <Option name="type" value="3" type="int"/>
                </Option>
                <Option name="outlineWidth" type="Map">
                  <Option name="active" value="true" type="bool"/>
                  <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 2.35, 3.6), 3.6)" type="QString"/>
                  <Option name="type" value="3" type="int"/>
                </Option>
              </Option>
              <Option name="type" value="collection" type="QString"/>
            </Option>
          </data_defined_properties>
        </layer>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="0">
          <Option type="Map">
            <Option name="SymbolType" value="Fill" type="QString"/>
            <Option name="geometryModifier" value="coalesce(make_polygon(exterior_ring($geometry), exterior_ring($geometry)), $geometry)" type="QString"/>
            <Option name="units" value="MapUnit" type="QString"/>
          </Option>
          <symbol alpha="1" clip_to_extent="1" name="@1@1" type="fill" force_rhr="0">
            <layer pass="0" enabled="1" class="SimpleFill" locked="1">
              <Option type="Map">
                <Option name="color" value="0,0,0,0" type="QString"/>
                <Option name="joinstyle" value="miter" type="QString"/>
                <Option name="outline_color" value="0,0,0,110" type="QString"/>
                <Option name="outline_style" value="solid" type="QString"/>
                <Option name="outline_width" value="1.4" type="QString"/>
                <Option name="outline_width_unit" value="MM" type="QString"/>
                <Option name="style" value="no" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="outlineWidth" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 0.65, 1.4), 1.4)" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
            <layer pass="0" enabled="1" class="SimpleFill" locked="1">
              <Option type="Map">
                <Option name="color" value="0,0,0,0" type="QString"/>
                <Option name="joinstyle" value="miter" type="QString"/>
                <Option name="outline_color" value="0,0,0,255" type="QString"/>
                <Option name="outline_style" value="no" type="QString"/>
                <Option name="outline_width" value="1.4" type="QString"/>
                <Option name="outline_width_unit" value="MM" type="QString"/>
                <Option name="style" value="no" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="outlineStyle" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="if(coalesce(map_exist(@seam_inspector_selected, @layer_id || ' ' || $id), false), 'solid', 'no')" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                    <Option name="outlineWidth" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 0.65, 1.4), 1.4) + 0.5" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
            <layer pass="0" enabled="1" class="SimpleFill" locked="0">
              <Option type="Map">
                <Option name="color" value="240,200,0,255" type="QString"/>
                <Option name="joinstyle" value="miter" type="QString"/>
                <Option name="outline_color" value="240,200,0,255" type="QString"/>
                <Option name="outline_style" value="solid" type="QString"/>
                <Option name="outline_width" value="0.8" type="QString"/>
                <Option name="outline_width_unit" value="MM" type="QString"/>
                <Option name="style" value="no" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="outlineWidth" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 0.35, 0.8), 0.8)" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="1">
          <Option type="Map">
            <Option name="SymbolType" value="Marker" type="QString"/>
            <Option name="geometryModifier" value="with_variable('seen', intersection($geometry, transform(@map_extent, @map_crs, @layer_crs)), make_point(x_max(@seen), y_min(@seen), (240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs)))))" type="QString"/>
            <Option name="units" value="MapUnit" type="QString"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" value="" type="QString"/>
              <Option name="properties" type="Map">
                <Option name="enabled" type="Map">
                  <Option name="active" value="true" type="bool"/>
                  <Option name="expression" value="coalesce(attribute('observer') IN ('visible', 'invisible', 'unsure') AND (240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))) &gt; 3, false)" type="QString"/>
                  <Option name="type" value="3" type="int"/>
                </Option>
              </Option>
              <Option name="type" value="collection" type="QString"/>
            </Option>
          </data_defined_properties>
          <symbol alpha="1" clip_to_extent="1" name="@1@2" type="marker" force_rhr="0">
            <layer pass="0" enabled="1" class="SvgMarker" locked="0" userFlags="DisableSelectionRecoloring">
              <Option type="Map">
                <Option name="name" value="base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiMyMDIwMjAiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTQuNSAxMiBRMTIgMy41IDE5LjUgMTIgUTEyIDIwLjUgNC41IDEyIFoiIGZpbGw9Im5vbmUiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMi43IiBmaWxsPSIjZmZmZmZmIi8+PC9zdmc+" type="QString"/>
                <Option name="size" value="4" type="QString"/>
                <Option name="size_unit" value="MM" type="QString"/>
                <Option name="horizontal_anchor_point" value="2" type="QString"/>
                <Option name="vertical_anchor_point" value="2" type="QString"/>
                <Option name="offset" value="-0.6,-0.6" type="QString"/>
                <Option name="offset_unit" value="MM" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="name" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="CASE WHEN &quot;observer&quot; = 'visible' THEN 'base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiMyMDIwMjAiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTQuNSAxMiBRMTIgMy41IDE5LjUgMTIgUTEyIDIwLjUgNC41IDEyIFoiIGZpbGw9Im5vbmUiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMi43IiBmaWxsPSIjZmZmZmZmIi8+PC9zdmc+' WHEN &quot;observer&quot; = 'invisible' THEN 'base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiNmZmZmZmYiIHN0cm9rZT0iIzIwMjAyMCIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTQuNSAxMiBRMTIgMy41IDE5LjUgMTIgUTEyIDIwLjUgNC41IDEyIFoiIGZpbGw9Im5vbmUiIHN0cm9rZT0iIzIwMjAyMCIgc3Ryb2tlLXdpZHRoPSIyIi8+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMi43IiBmaWxsPSIjMjAyMDIwIi8+PHBhdGggZD0iTTYgMTguNSBMMTggNS41IiBzdHJva2U9IiMyMDIwMjAiIHN0cm9rZS13aWR0aD0iMi40Ii8+PC9zdmc+' WHEN &quot;observer&quot; = 'unsure' THEN 'base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiNmZmZmZmYiIHN0cm9rZT0iIzIwMjAyMCIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTguMiA5LjUgUTguMiA1LjggMTIgNS44IFExNS44IDUuOCAxNS44IDkuMiBRMTUuOCAxMS40IDEzLjYgMTIuNCBRMTIgMTMuMiAxMiAxNSIgZmlsbD0ibm9uZSIgc3Ryb2tlPSIjMjAyMDIwIiBzdHJva2Utd2lkdGg9IjIuNiIvPjxjaXJjbGUgY3g9IjEyIiBjeT0iMTguNCIgcj0iMS43IiBmaWxsPSIjMjAyMDIwIi8+PC9zdmc+' END" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                    <Option name="size" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear(z($geometry), 3, 14, 2, 4.5), 0)" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
      </symbol>
      <symbol alpha="1" clip_to_extent="1" name="2" type="fill" force_rhr="0">
        <layer pass="0" enabled="1" class="SimpleLine" locked="1">
          <Option type="Map">
            <Option name="capstyle" value="square" type="QString"/>
            <Option name="joinstyle" value="miter" type="QString"/>
            <Option name="line_color" value="255,255,0,0" type="QString"/>
            <Option name="line_style" value="solid" type="QString"/>
            <Option name="line_width" value="3.6" type="QString"/>
            <Option name="line_width_unit" value="MM" type="QString"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" value="" type="QString"/>
              <Option name="properties" type="Map">
                <Option name="enabled" type="Map">
                  <Option name="active" value="true" type="bool"/>
                  <Option name="expression" value="coalesce(map_exist(@seam_inspector_selected, @layer_id || ' ' || $id), false)" type="QString"/>
                  <Option name="type" value="3" type="int"/>
                </Option>
                <Option name="outlineWidth" type="Map">
                  <Option name="active" value="true" type="bool"/>
                  <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 2.35, 3.6), 3.6)" type="QString"/>
                  <Option name="type" value="3" type="int"/>
                </Option>
              </Option>
              <Option name="type" value="collection" type="QString"/>
            </Option>
          </data_defined_properties>
        </layer>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="0">
          <Option type="Map">
            <Option name="SymbolType" value="Fill" type="QString"/>
            <Option name="geometryModifier" value="coalesce(make_polygon(exterior_ring($geometry), exterior_ring($geometry)), $geometry)" type="QString"/>
            <Option name="units" value="MapUnit" type="QString"/>
          </Option>
          <symbol alpha="1" clip_to_extent="1" name="@2@1" type="fill" force_rhr="0">
            <layer pass="0" enabled="1" class="SimpleFill" locked="1">
              <Option type="Map">
                <Option name="color" value="0,0,0,0" type="QString"/>
                <Option name="joinstyle" value="miter" type="QString"/>
                <Option name="outline_color" value="255,255,255,170" type="QString"/>
                <Option name="outline_style" value="solid" type="QString"/>
                <Option name="outline_width" value="1.4" type="QString"/>
                <Option name="outline_width_unit" value="MM" type="QString"/>
                <Option name="style" value="no" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="outlineWidth" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 0.65, 1.4), 1.4)" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
            <layer pass="0" enabled="1" class="SimpleFill" locked="1">
              <Option type="Map">
                <Option name="color" value="0,0,0,0" type="QString"/>
                <Option name="joinstyle" value="miter" type="QString"/>
                <Option name="outline_color" value="0,0,0,255" type="QString"/>
                <Option name="outline_style" value="no" type="QString"/>
                <Option name="outline_width" value="1.4" type="QString"/>
                <Option name="outline_width_unit" value="MM" type="QString"/>
                <Option name="style" value="no" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="outlineStyle" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="if(coalesce(map_exist(@seam_inspector_selected, @layer_id || ' ' || $id), false), 'solid', 'no')" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                    <Option name="outlineWidth" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 0.65, 1.4), 1.4) + 0.5" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
            <layer pass="0" enabled="1" class="SimpleFill" locked="0">
              <Option type="Map">
                <Option name="color" value="0,114,178,255" type="QString"/>
                <Option name="joinstyle" value="miter" type="QString"/>
                <Option name="outline_color" value="0,114,178,255" type="QString"/>
                <Option name="outline_style" value="solid" type="QString"/>
                <Option name="outline_width" value="0.8" type="QString"/>
                <Option name="outline_width_unit" value="MM" type="QString"/>
                <Option name="style" value="no" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="outlineWidth" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 0.35, 0.8), 0.8)" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="1">
          <Option type="Map">
            <Option name="SymbolType" value="Marker" type="QString"/>
            <Option name="geometryModifier" value="with_variable('seen', intersection($geometry, transform(@map_extent, @map_crs, @layer_crs)), make_point(x_max(@seen), y_min(@seen), (240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs)))))" type="QString"/>
            <Option name="units" value="MapUnit" type="QString"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" value="" type="QString"/>
              <Option name="properties" type="Map">
                <Option name="enabled" type="Map">
                  <Option name="active" value="true" type="bool"/>
                  <Option name="expression" value="coalesce(attribute('observer') IN ('visible', 'invisible', 'unsure') AND (240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))) &gt; 3, false)" type="QString"/>
                  <Option name="type" value="3" type="int"/>
                </Option>
              </Option>
              <Option name="type" value="collection" type="QString"/>
            </Option>
          </data_defined_properties>
          <symbol alpha="1" clip_to_extent="1" name="@2@2" type="marker" force_rhr="0">
            <layer pass="0" enabled="1" class="SvgMarker" locked="0" userFlags="DisableSelectionRecoloring">
              <Option type="Map">
                <Option name="name" value="base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiMyMDIwMjAiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTQuNSAxMiBRMTIgMy41IDE5LjUgMTIgUTEyIDIwLjUgNC41IDEyIFoiIGZpbGw9Im5vbmUiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMi43IiBmaWxsPSIjZmZmZmZmIi8+PC9zdmc+" type="QString"/>
                <Option name="size" value="4" type="QString"/>
                <Option name="size_unit" value="MM" type="QString"/>
                <Option name="horizontal_anchor_point" value="2" type="QString"/>
                <Option name="vertical_anchor_point" value="2" type="QString"/>
                <Option name="offset" value="-0.6,-0.6" type="QString"/>
                <Option name="offset_unit" value="MM" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="name" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="CASE WHEN &quot;observer&quot; = 'visible' THEN 'base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiMyMDIwMjAiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTQuNSAxMiBRMTIgMy41IDE5LjUgMTIgUTEyIDIwLjUgNC41IDEyIFoiIGZpbGw9Im5vbmUiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMi43IiBmaWxsPSIjZmZmZmZmIi8+PC9zdmc+' WHEN &quot;observer&quot; = 'invisible' THEN 'base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiNmZmZmZmYiIHN0cm9rZT0iIzIwMjAyMCIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTQuNSAxMiBRMTIgMy41IDE5LjUgMTIgUTEyIDIwLjUgNC41IDEyIFoiIGZpbGw9Im5vbmUiIHN0cm9rZT0iIzIwMjAyMCIgc3Ryb2tlLXdpZHRoPSIyIi8+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMi43IiBmaWxsPSIjMjAyMDIwIi8+PHBhdGggZD0iTTYgMTguNSBMMTggNS41IiBzdHJva2U9IiMyMDIwMjAiIHN0cm9rZS13aWR0aD0iMi40Ii8+PC9zdmc+' WHEN &quot;observer&quot; = 'unsure' THEN 'base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiNmZmZmZmYiIHN0cm9rZT0iIzIwMjAyMCIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTguMiA5LjUgUTguMiA1LjggMTIgNS44IFExNS44IDUuOCAxNS44IDkuMiBRMTUuOCAxMS40IDEzLjYgMTIuNCBRMTIgMTMuMiAxMiAxNSIgZmlsbD0ibm9uZSIgc3Ryb2tlPSIjMjAyMDIwIiBzdHJva2Utd2lkdGg9IjIuNiIvPjxjaXJjbGUgY3g9IjEyIiBjeT0iMTguNCIgcj0iMS43IiBmaWxsPSIjMjAyMDIwIi8+PC9zdmc+' END" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                    <Option name="size" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear(z($geometry), 3, 14, 2, 4.5), 0)" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
      </symbol>
      <symbol alpha="1" clip_to_extent="1" name="3" type="fill" force_rhr="0">
        <layer pass="0" enabled="1" class="SimpleLine" locked="1">
          <Option type="Map">
            <Option name="capstyle" value="square" type="QString"/>
            <Option name="joinstyle" value="miter" type="QString"/>
            <Option name="line_color" value="255,255,0,0" type="QString"/>
            <Option name="line_style" value="solid" type="QString"/>
            <Option name="line_width" value="3.3" type="QString"/>
            <Option name="line_width_unit" value="MM" type="QString"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" value="" type="QString"/>
              <Option name="properties" type="Map">
                <Option name="enabled" type="Map">
                  <Option name="active" value="true" type="bool"/>
                  <Option name="expression" value="coalesce(map_exist(@seam_inspector_selected, @layer_id || ' ' || $id), false)" type="QString"/>
                  <Option name="type" value="3" type="int"/>
                </Option>
                <Option name="outlineWidth" type="Map">
                  <Option name="active" value="true" type="bool"/>
                  <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 2.3, 3.3), 3.3)" type="QString"/>
                  <Option name="type" value="3" type="int"/>
                </Option>
              </Option>
              <Option name="type" value="collection" type="QString"/>
            </Option>
          </data_defined_properties>
        </layer>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="0">
          <Option type="Map">
            <Option name="SymbolType" value="Fill" type="QString"/>
            <Option name="geometryModifier" value="coalesce(make_polygon(exterior_ring($geometry), exterior_ring($geometry)), $geometry)" type="QString"/>
            <Option name="units" value="MapUnit" type="QString"/>
          </Option>
          <symbol alpha="1" clip_to_extent="1" name="@3@1" type="fill" force_rhr="0">
            <layer pass="0" enabled="1" class="SimpleFill" locked="1">
              <Option type="Map">
                <Option name="color" value="0,0,0,0" type="QString"/>
                <Option name="joinstyle" value="miter" type="QString"/>
                <Option name="outline_color" value="0,0,0,90" type="QString"/>
                <Option name="outline_style" value="solid" type="QString"/>
                <Option name="outline_width" value="1.1" type="QString"/>
                <Option name="outline_width_unit" value="MM" type="QString"/>
                <Option name="style" value="no" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="outlineWidth" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 0.6, 1.1), 1.1)" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
            <layer pass="0" enabled="1" class="SimpleFill" locked="1">
              <Option type="Map">
                <Option name="color" value="0,0,0,0" type="QString"/>
                <Option name="joinstyle" value="miter" type="QString"/>
                <Option name="outline_color" value="0,0,0,255" type="QString"/>
                <Option name="outline_style" value="no" type="QString"/>
                <Option name="outline_width" value="1.1" type="QString"/>
                <Option name="outline_width_unit" value="MM" type="QString"/>
                <Option name="style" value="no" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="outlineStyle" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="if(coalesce(map_exist(@seam_inspector_selected, @layer_id || ' ' || $id), false), 'solid', 'no')" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                    <Option name="outlineWidth" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 0.6, 1.1), 1.1) + 0.5" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
            <layer pass="0" enabled="1" class="SimpleFill" locked="0">
              <Option type="Map">
                <Option name="color" value="138,138,138,255" type="QString"/>
                <Option name="joinstyle" value="miter" type="QString"/>
                <Option name="outline_color" value="138,138,138,255" type="QString"/>
                <Option name="outline_style" value="dash" type="QString"/>
                <Option name="outline_width" value="0.5" type="QString"/>
                <Option name="outline_width_unit" value="MM" type="QString"/>
                <Option name="style" value="no" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="outlineWidth" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 0.3, 0.5), 0.5)" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="1">
          <Option type="Map">
            <Option name="SymbolType" value="Marker" type="QString"/>
            <Option name="geometryModifier" value="with_variable('seen', intersection($geometry, transform(@map_extent, @map_crs, @layer_crs)), make_point(x_max(@seen), y_min(@seen), (240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs)))))" type="QString"/>
            <Option name="units" value="MapUnit" type="QString"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" value="" type="QString"/>
              <Option name="properties" type="Map">
                <Option name="enabled" type="Map">
                  <Option name="active" value="true" type="bool"/>
                  <Option name="expression" value="coalesce(attribute('observer') IN ('visible', 'invisible', 'unsure') AND (240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))) &gt; 3, false)" type="QString"/>
                  <Option name="type" value="3" type="int"/>
                </Option>
              </Option>
              <Option name="type" value="collection" type="QString"/>
            </Option>
          </data_defined_properties>
          <symbol alpha="1" clip_to_extent="1" name="@3@2" type="marker" force_rhr="0">
            <layer pass="0" enabled="1" class="SvgMarker" locked="0" userFlags="DisableSelectionRecoloring">
              <Option type="Map">
                <Option name="name" value="base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiMyMDIwMjAiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTQuNSAxMiBRMTIgMy41IDE5LjUgMTIgUTEyIDIwLjUgNC41IDEyIFoiIGZpbGw9Im5vbmUiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMi43IiBmaWxsPSIjZmZmZmZmIi8+PC9zdmc+" type="QString"/>
                <Option name="size" value="4" type="QString"/>
                <Option name="size_unit" value="MM" type="QString"/>
                <Option name="horizontal_anchor_point" value="2" type="QString"/>
                <Option name="vertical_anchor_point" value="2" type="QString"/>
                <Option name="offset" value="-0.6,-0.6" type="QString"/>
                <Option name="offset_unit" value="MM" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="name" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="CASE WHEN &quot;observer&quot; = 'visible' THEN 'base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiMyMDIwMjAiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTQuNSAxMiBRMTIgMy41IDE5LjUgMTIgUTEyIDIwLjUgNC41IDEyIFoiIGZpbGw9Im5vbmUiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMi43IiBmaWxsPSIjZmZmZmZmIi8+PC9zdmc+' WHEN &quot;observer&quot; = 'invisible' THEN 'base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiNmZmZmZmYiIHN0cm9rZT0iIzIwMjAyMCIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTQuNSAxMiBRMTIgMy41IDE5LjUgMTIgUTEyIDIwLjUgNC41IDEyIFoiIGZpbGw9Im5vbmUiIHN0cm9rZT0iIzIwMjAyMCIgc3Ryb2tlLXdpZHRoPSIyIi8+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMi43IiBmaWxsPSIjMjAyMDIwIi8+PHBhdGggZD0iTTYgMTguNSBMMTggNS41IiBzdHJva2U9IiMyMDIwMjAiIHN0cm9rZS13aWR0aD0iMi40Ii8+PC9zdmc+' WHEN &quot;observer&quot; = 'unsure' THEN 'base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiNmZmZmZmYiIHN0cm9rZT0iIzIwMjAyMCIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTguMiA5LjUgUTguMiA1LjggMTIgNS44IFExNS44IDUuOCAxNS44IDkuMiBRMTUuOCAxMS40IDEzLjYgMTIuNCBRMTIgMTMuMiAxMiAxNSIgZmlsbD0ibm9uZSIgc3Ryb2tlPSIjMjAyMDIwIiBzdHJva2Utd2lkdGg9IjIuNiIvPjxjaXJjbGUgY3g9IjEyIiBjeT0iMTguNCIgcj0iMS43IiBmaWxsPSIjMjAyMDIwIi8+PC9zdmc+' END" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                    <Option name="size" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear(z($geometry), 3, 14, 2, 4.5), 0)" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
      </symbol>
      <symbol alpha="1" clip_to_extent="1" name="4" type="fill" force_rhr="0">
        <layer pass="0" enabled="1" class="SimpleLine" locked="1">
          <Option type="Map">
            <Option name="capstyle" value="square" type="QString"/>
            <Option name="joinstyle" value="miter" type="QString"/>
            <Option name="line_color" value="255,255,0,0" type="QString"/>
            <Option name="line_style" value="solid" type="QString"/>
            <Option name="line_width" value="3.3" type="QString"/>
            <Option name="line_width_unit" value="MM" type="QString"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" value="" type="QString"/>
              <Option name="properties" type="Map">
                <Option name="enabled" type="Map">
                  <Option name="active" value="true" type="bool"/>
                  <Option name="expression" value="coalesce(map_exist(@seam_inspector_selected, @layer_id || ' ' || $id), false)" type="QString"/>
                  <Option name="type" value="3" type="int"/>
                </Option>
                <Option name="outlineWidth" type="Map">
                  <Option name="active" value="true" type="bool"/>
                  <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 2.3, 3.3), 3.3)" type="QString"/>
                  <Option name="type" value="3" type="int"/>
                </Option>
              </Option>
              <Option name="type" value="collection" type="QString"/>
            </Option>
          </data_defined_properties>
        </layer>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="0">
          <Option type="Map">
            <Option name="SymbolType" value="Fill" type="QString"/>
            <Option name="geometryModifier" value="coalesce(make_polygon(exterior_ring($geometry), exterior_ring($geometry)), $geometry)" type="QString"/>
            <Option name="units" value="MapUnit" type="QString"/>
          </Option>
          <symbol alpha="1" clip_to_extent="1" name="@4@1" type="fill" force_rhr="0">
            <layer pass="0" enabled="1" class="SimpleFill" locked="1">
              <Option type="Map">
                <Option name="color" value="0,0,0,0" type="QString"/>
                <Option name="joinstyle" value="miter" type="QString"/>
                <Option name="outline_color" value="0,0,0,90" type="QString"/>
                <Option name="outline_style" value="solid" type="QString"/>
                <Option name="outline_width" value="1.1" type="QString"/>
                <Option name="outline_width_unit" value="MM" type="QString"/>
                <Option name="style" value="no" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="outlineWidth" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 0.6, 1.1), 1.1)" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
            <layer pass="0" enabled="1" class="SimpleFill" locked="1">
              <Option type="Map">
                <Option name="color" value="0,0,0,0" type="QString"/>
                <Option name="joinstyle" value="miter" type="QString"/>
                <Option name="outline_color" value="0,0,0,255" type="QString"/>
                <Option name="outline_style" value="no" type="QString"/>
                <Option name="outline_width" value="1.1" type="QString"/>
                <Option name="outline_width_unit" value="MM" type="QString"/>
                <Option name="style" value="no" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="outlineStyle" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="if(coalesce(map_exist(@seam_inspector_selected, @layer_id || ' ' || $id), false), 'solid', 'no')" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                    <Option name="outlineWidth" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 0.6, 1.1), 1.1) + 0.5" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
            <layer pass="0" enabled="1" class="SimpleFill" locked="0">
              <Option type="Map">
                <Option name="color" value="200,200,200,255" type="QString"/>
                <Option name="joinstyle" value="miter" type="QString"/>
                <Option name="outline_color" value="200,200,200,255" type="QString"/>
                <Option name="outline_style" value="dot" type="QString"/>
                <Option name="outline_width" value="0.5" type="QString"/>
                <Option name="outline_width_unit" value="MM" type="QString"/>
                <Option name="style" value="no" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="outlineWidth" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))), 2, 12, 0.3, 0.5), 0.5)" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="1">
          <Option type="Map">
            <Option name="SymbolType" value="Marker" type="QString"/>
            <Option name="geometryModifier" value="with_variable('seen', intersection($geometry, transform(@map_extent, @map_crs, @layer_crs)), make_point(x_max(@seen), y_min(@seen), (240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs)))))" type="QString"/>
            <Option name="units" value="MapUnit" type="QString"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" value="" type="QString"/>
              <Option name="properties" type="Map">
                <Option name="enabled" type="Map">
                  <Option name="active" value="true" type="bool"/>
                  <Option name="expression" value="coalesce(attribute('observer') IN ('visible', 'invisible', 'unsure') AND (240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))) &gt; 3, false)" type="QString"/>
                  <Option name="type" value="3" type="int"/>
                </Option>
              </Option>
              <Option name="type" value="collection" type="QString"/>
            </Option>
          </data_defined_properties>
          <symbol alpha="1" clip_to_extent="1" name="@4@2" type="marker" force_rhr="0">
            <layer pass="0" enabled="1" class="SvgMarker" locked="0" userFlags="DisableSelectionRecoloring">
              <Option type="Map">
                <Option name="name" value="base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiMyMDIwMjAiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTQuNSAxMiBRMTIgMy41IDE5LjUgMTIgUTEyIDIwLjUgNC41IDEyIFoiIGZpbGw9Im5vbmUiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMi43IiBmaWxsPSIjZmZmZmZmIi8+PC9zdmc+" type="QString"/>
                <Option name="size" value="4" type="QString"/>
                <Option name="size_unit" value="MM" type="QString"/>
                <Option name="horizontal_anchor_point" value="2" type="QString"/>
                <Option name="vertical_anchor_point" value="2" type="QString"/>
                <Option name="offset" value="-0.6,-0.6" type="QString"/>
                <Option name="offset_unit" value="MM" type="QString"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" value="" type="QString"/>
                  <Option name="properties" type="Map">
                    <Option name="name" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="CASE WHEN &quot;observer&quot; = 'visible' THEN 'base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiMyMDIwMjAiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTQuNSAxMiBRMTIgMy41IDE5LjUgMTIgUTEyIDIwLjUgNC41IDEyIFoiIGZpbGw9Im5vbmUiIHN0cm9rZT0iI2ZmZmZmZiIgc3Ryb2tlLXdpZHRoPSIyIi8+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMi43IiBmaWxsPSIjZmZmZmZmIi8+PC9zdmc+' WHEN &quot;observer&quot; = 'invisible' THEN 'base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiNmZmZmZmYiIHN0cm9rZT0iIzIwMjAyMCIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTQuNSAxMiBRMTIgMy41IDE5LjUgMTIgUTEyIDIwLjUgNC41IDEyIFoiIGZpbGw9Im5vbmUiIHN0cm9rZT0iIzIwMjAyMCIgc3Ryb2tlLXdpZHRoPSIyIi8+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMi43IiBmaWxsPSIjMjAyMDIwIi8+PHBhdGggZD0iTTYgMTguNSBMMTggNS41IiBzdHJva2U9IiMyMDIwMjAiIHN0cm9rZS13aWR0aD0iMi40Ii8+PC9zdmc+' WHEN &quot;observer&quot; = 'unsure' THEN 'base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PGNpcmNsZSBjeD0iMTIiIGN5PSIxMiIgcj0iMTEiIGZpbGw9IiNmZmZmZmYiIHN0cm9rZT0iIzIwMjAyMCIgc3Ryb2tlLXdpZHRoPSIyIi8+PHBhdGggZD0iTTguMiA5LjUgUTguMiA1LjggMTIgNS44IFExNS44IDUuOCAxNS44IDkuMiBRMTUuOCAxMS40IDEzLjYgMTIuNCBRMTIgMTMuMiAxMiAxNSIgZmlsbD0ibm9uZSIgc3Ryb2tlPSIjMjAyMDIwIiBzdHJva2Utd2lkdGg9IjIuNiIvPjxjaXJjbGUgY3g9IjEyIiBjeT0iMTguNCIgcj0iMS43IiBmaWxsPSIjMjAyMDIwIi8+PC9zdmc+' END" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                    <Option name="size" type="Map">
                      <Option name="active" value="true" type="bool"/>
                      <Option name="expression" value="coalesce(scale_linear(z($geometry), 3, 14, 2, 4.5), 0)" type="QString"/>
                      <Option name="type" value="3" type="int"/>
                    </Option>
                  </Option>
                  <Option name="type" value="collection" type="QString"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
      </symbol>
    </symbols>
    <orderby>
      <orderByClause asc="1" nullsFirst="0">coalesce(map_exist(@seam_inspector_selected, @layer_id || ' ' || $id), false)</orderByClause>
      <orderByClause asc="1" nullsFirst="0">array_find(array('', 'preserved', 'not_comparable', 'reduced', 'significant'), coalesce("verdict", ''))</orderByClause>
    </orderby>
  </renderer-v2>
  <labeling type="simple">
    <settings calloutType="simple">
      <text-style isExpression="1" fontFamily="DejaVu Sans" fontSize="8.5" fontSizeUnit="Point" fontWeight="50" fontItalic="0" textColor="32,32,32,255" textOpacity="1" fontKerning="1" multilineHeight="1" blendMode="0" fieldName="&quot;window_id&quot; || coalesce(' · ' || if(attribute('loss') > 0, format_number(attribute('loss'), if(attribute('loss') >= 10, 0, 1)) || ' m²', NULL), '')">
        <text-buffer bufferDraw="1" bufferSize="0.9" bufferSizeUnits="MM" bufferColor="255,255,255,255" bufferOpacity="1" bufferNoFill="1" bufferJoinStyle="128" bufferBlendMode="0"/>
      </text-style>
      <placement placement="1" quadOffset="8" xOffset="1.5" yOffset="1.5" offsetUnits="MM" dist="0" distUnits="MM" offsetType="0" priority="5" polygonPlacementFlags="2" placementFlags="10" preserveRotation="1" geometryGeneratorEnabled="1" geometryGeneratorType="PointGeometry" layerType="UnknownGeometry" geometryGenerator="with_variable('seen', intersection($geometry, transform(@map_extent, @map_crs, @layer_crs)), make_point(x_min(@seen), y_max(@seen)))"/>
      <rendering drawLabels="1" displayAll="0" obstacle="0" obstacleType="1" obstacleFactor="1" fontMaxPixelSize="10000" fontMinPixelSize="0" fontLimitPixelSize="0" limitNumLabels="0" maxNumLabels="2000" scaleVisibility="0" upsidedownLabels="0" unplacedVisibility="0" labelPerPart="0" mergeLines="0" minFeatureSize="0" zIndex="0"/>
      <dd_properties>
        <Option type="Map">
          <Option name="name" value="" type="QString"/>
          <Option name="properties" type="Map">
            <Option name="AlwaysShow" type="Map">
              <Option name="active" value="true" type="bool"/>
              <Option name="expression" value="coalesce(map_exist(@seam_inspector_selected, @layer_id || ' ' || $id), false)" type="QString"/>
              <Option name="type" value="3" type="int"/>
            </Option>
            <Option name="Bold" type="Map">
              <Option name="active" value="true" type="bool"/>
              <Option name="expression" value="coalesce(map_exist(@seam_inspector_selected, @layer_id || ' ' || $id), false)" type="QString"/>
              <Option name="type" value="3" type="int"/>
            </Option>
            <Option name="Priority" type="Map">
              <Option name="active" value="true" type="bool"/>
              <Option name="expression" value="if(coalesce(map_exist(@seam_inspector_selected, @layer_id || ' ' || $id), false), 10, 9 * (1 - coalesce(min(max(if(attribute('reference') = 'seam', if(attribute('verdict') = 'significant', 0, attribute('kept_1')), attribute('ratio_1')), 0) / 2, 1), 0.9)))" type="QString"/>
              <Option name="type" value="3" type="int"/>
            </Option>
            <Option name="Show" type="Map">
              <Option name="active" value="true" type="bool"/>
              <Option name="expression" value="coalesce(map_exist(@seam_inspector_selected, @layer_id || ' ' || $id), false) OR coalesce((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))) &gt; CASE WHEN &quot;verdict&quot; = 'significant' THEN 2 WHEN &quot;verdict&quot; IN ('preserved', 'not_comparable') THEN 9 ELSE 4 END, true)" type="QString"/>
              <Option name="type" value="3" type="int"/>
            </Option>
            <Option name="OffsetQuad" type="Map">
              <Option name="active" value="true" type="bool"/>
              <Option name="expression" value="if((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))) &lt; 9, 2, 8)" type="QString"/>
              <Option name="type" value="3" type="int"/>
            </Option>
            <Option name="OffsetXY" type="Map">
              <Option name="active" value="true" type="bool"/>
              <Option name="expression" value="if((240 * bounds_width($geometry) / bounds_width(transform(@map_extent, @map_crs, @layer_crs))) &lt; 9, '0.5,-0.8', '1.5,1.5')" type="QString"/>
              <Option name="type" value="3" type="int"/>
            </Option>
          </Option>
          <Option name="type" value="collection" type="QString"/>
        </Option>
      </dd_properties>
    </settings>
  </labeling>
  <blendMode>0</blendMode>
  <featureBlendMode>0</featureBlendMode>
  <mapTip>&lt;b&gt;[% /*tr*/'Window' || ' ' || coalesce(replace(to_string("window_id"), map('&amp;', '&amp;amp;', '&lt;', '&amp;lt;')), '') %]&lt;/b&gt;: [% map_get(map('significant', /*tr*/'significant loss', 'reduced', /*tr*/'reduced', 'preserved', /*tr*/'preserved', 'not_comparable', /*tr*/'not comparable', '', /*tr*/'not inspected'), coalesce("verdict", '')) %][% coalesce('&lt;br&gt;' || replace(attribute('reason'), map('&amp;', '&amp;amp;', '&lt;', '&amp;lt;')), '') %][% coalesce('&lt;br&gt;' || if(attribute('loss') > 0, /*tr*/'loss' || ': ' || format_number(attribute('loss'), if(attribute('loss') >= 10, 0, 1)) || ' m²', NULL), '') %][% coalesce('&lt;br&gt;' || if(attribute('reference') = 'seam', if(attribute('kept_high') &lt; 1 OR attribute('verdict') = 'preserved', /*tr*/'kept along the seam' || ': ' || format_number(100 * attribute('kept_1'), if(round(100 * attribute('kept_1')) != 70 or 100 * attribute('kept_1') = 70, 0, if(round(100 * attribute('kept_1'), 1) != 70, 1, 2))) || ' % (' || format_number(100 * attribute('kept_low'), if(round(100 * attribute('kept_low')) != 70 or 100 * attribute('kept_low') = 70, 0, if(round(100 * attribute('kept_low'), 1) != 70, 1, 2))) || '–' || format_number(100 * attribute('kept_high'), if(round(100 * attribute('kept_high')) != 70 or 100 * attribute('kept_high') = 70, 0, if(round(100 * attribute('kept_high'), 1) != 70, 1, 2))) || ' %)' || if(max(coalesce(attribute('band_width'), 0), coalesce(attribute('feather_width'), 0)) >= 0.05, ', ' || /*tr*/'in a width of' || ' ' || format_number(max(coalesce(attribute('band_width'), 0), coalesce(attribute('feather_width'), 0)), 1) || ' m', ''), NULL), /*tr*/'ratio 1' || ': ' || format_number(attribute('ratio_1'), 2)), '') %][% coalesce('&lt;br&gt;' || /*tr*/'visibility at 2x (JND)' || ': ' || format_number(attribute('visibility'), 1), '') %][% if(attribute('misfit') >= 0.5, '&lt;br&gt;' || /*tr*/'images apart in the mosaic (px)' || ': ' || format_number(attribute('misfit'), 1), '') %][% coalesce('&lt;br&gt;' || array_to_string(array_foreach(string_to_array(attribute('causes'), '; '), coalesce(map_get(map('missing source', /*tr*/'missing source', 'misregistration', /*tr*/'misregistration', 'feathering', /*tr*/'feathering', 'other mixture', /*tr*/'other mixture', 'blur', /*tr*/'blur', 'resampled', /*tr*/'resampled', 'sharpened', /*tr*/'sharpened', 'compressed', /*tr*/'compressed', 'noise added', /*tr*/'noise added', 'clipping', /*tr*/'clipping', 'dodging', /*tr*/'dodging', 'gamma', /*tr*/'gamma', 'colour shift', /*tr*/'colour shift', 'narrowed histogram', /*tr*/'narrowed histogram', 'balanced', /*tr*/'balanced', 'none', /*tr*/'none', 'unclear', /*tr*/'unclear'), @element), replace(@element, map('&amp;', '&amp;amp;', '&lt;', '&amp;lt;')))), '; '), '') %][% coalesce('&lt;br&gt;' || /*tr*/'observer' || ': ' || map_get(map('visible', /*tr*/'visible', 'invisible', /*tr*/'invisible', 'unsure', /*tr*/'not sure'), attribute('observer')), '') %]</mapTip>
  <layerGeometryType>2</layerGeometryType>
  <previewExpression>/*tr*/'Window' || ' ' || coalesce(to_string("window_id"), '') || ': ' || coalesce(map_get(map('significant', /*tr*/'significant loss', 'reduced', /*tr*/'reduced', 'preserved', /*tr*/'preserved', 'not_comparable', /*tr*/'not comparable', '', /*tr*/'not inspected'), coalesce("verdict", '')), "verdict")</previewExpression>
  <fieldWords>
    <field names="verdict paper_verdict">
      <item value="significant" label="significant loss"/>
      <item value="reduced" label="reduced"/>
      <item value="preserved" label="preserved"/>
      <item value="not_comparable" label="not comparable"/>
      <item value="" label="not inspected"/>
    </field>
    <field names="reference">
      <item value="seam" label="the seam"/>
      <item value="composite" label="the composite"/>
      <item value="sources" label="the sources"/>
    </field>
    <field names="cause">
      <item value="missing source" label="missing source"/>
      <item value="misregistration" label="misregistration"/>
      <item value="feathering" label="feathering"/>
      <item value="blur" label="blur"/>
      <item value="resampled" label="resampled"/>
      <item value="sharpened" label="sharpened"/>
      <item value="compressed" label="compressed"/>
      <item value="noise added" label="noise added"/>
      <item value="clipping" label="clipping"/>
      <item value="dodging" label="dodging"/>
      <item value="gamma" label="gamma"/>
      <item value="colour shift" label="colour shift"/>
      <item value="narrowed histogram" label="narrowed histogram"/>
      <item value="balanced" label="balanced"/>
      <item value="none" label="none"/>
      <item value="unclear" label="unclear"/>
    </field>
    <field names="observer observer_2">
      <item value="visible" label="visible"/>
      <item value="invisible" label="invisible"/>
      <item value="unsure" label="not sure"/>
      <item value="" label="not judged"/>
    </field>
  </fieldWords>
</qgis>
