<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<qgis version="3.22.16-Białowieża" labelsEnabled="1" styleCategories="Symbology|Labeling|MapTips">
  <renderer-v2 attr="verdict" symbollevels="0" type="categorizedSymbol" forceraster="0" referencescale="-1" enableorderby="0">
    <categories>
      <category value="accepted" label="Accepted" symbol="0" render="true"/>
      <category value="rejected" label="Rejected" symbol="1" render="true"/>
      <category value="undecided" label="Undecided" symbol="2" render="true"/>
      <category value="no_seams" label="No seams" symbol="3" render="true"/>
    </categories>
    <symbols>
      <symbol alpha="1" clip_to_extent="1" name="0" type="fill" force_rhr="0">
        <layer pass="0" enabled="1" class="SimpleFill" locked="0">
          <Option type="Map">
            <Option name="color" value="0,158,115,60" type="QString"/>
            <Option name="style" value="solid" type="QString"/>
            <Option name="outline_color" value="0,158,115,255" type="QString"/>
            <Option name="outline_style" value="solid" type="QString"/>
            <Option name="outline_width" value="0.5" type="QString"/>
            <Option name="outline_width_unit" value="MM" type="QString"/>
            <Option name="joinstyle" value="miter" type="QString"/>
          </Option>
        </layer>
      </symbol>
      <symbol alpha="1" clip_to_extent="1" name="1" type="fill" force_rhr="0">
        <layer pass="0" enabled="1" class="SimpleFill" locked="0">
          <Option type="Map">
            <Option name="color" value="213,94,0,60" type="QString"/>
            <Option name="style" value="solid" type="QString"/>
            <Option name="outline_color" value="213,94,0,255" type="QString"/>
            <Option name="outline_style" value="solid" type="QString"/>
            <Option name="outline_width" value="0.5" type="QString"/>
            <Option name="outline_width_unit" value="MM" type="QString"/>
            <Option name="joinstyle" value="miter" type="QString"/>
          </Option>
        </layer>
      </symbol>
      <symbol alpha="1" clip_to_extent="1" name="2" type="fill" force_rhr="0">
        <layer pass="0" enabled="1" class="SimpleFill" locked="0">
          <Option type="Map">
            <Option name="color" value="230,159,0,60" type="QString"/>
            <Option name="style" value="solid" type="QString"/>
            <Option name="outline_color" value="230,159,0,255" type="QString"/>
            <Option name="outline_style" value="solid" type="QString"/>
            <Option name="outline_width" value="0.5" type="QString"/>
            <Option name="outline_width_unit" value="MM" type="QString"/>
            <Option name="joinstyle" value="miter" type="QString"/>
          </Option>
        </layer>
      </symbol>
      <symbol alpha="1" clip_to_extent="1" name="3" type="fill" force_rhr="0">
        <layer pass="0" enabled="1" class="SimpleFill" locked="0">
          <Option type="Map">
            <Option name="color" value="140,149,159,60" type="QString"/>
            <Option name="style" value="solid" type="QString"/>
            <Option name="outline_color" value="140,149,159,255" type="QString"/>
            <Option name="outline_style" value="solid" type="QString"/>
            <Option name="outline_width" value="0.5" type="QString"/>
            <Option name="outline_width_unit" value="MM" type="QString"/>
            <Option name="joinstyle" value="miter" type="QString"/>
          </Option>
        </layer>
      </symbol>
    </symbols>
  </renderer-v2>
  <labeling type="simple">
    <settings calloutType="simple">
      <text-style isExpression="0" fontFamily="DejaVu Sans" fontSize="6.5" fontSizeUnit="Point" fontWeight="50" fontItalic="0" textColor="64,72,80,255" textOpacity="1" fontKerning="1" multilineHeight="1" blendMode="0" fieldName="sheet">
        <text-buffer bufferDraw="1" bufferSize="0.6" bufferSizeUnits="MM" bufferColor="255,255,255,255" bufferOpacity="1" bufferNoFill="1" bufferJoinStyle="128" bufferBlendMode="0"/>
      </text-style>
      <placement placement="1" quadOffset="8" xOffset="1" yOffset="1" offsetUnits="MM" dist="0" distUnits="MM" offsetType="0" priority="5" polygonPlacementFlags="2" placementFlags="10" preserveRotation="1" geometryGeneratorEnabled="1" geometryGeneratorType="PointGeometry" layerType="UnknownGeometry" geometryGenerator="make_point(x_min($geometry), y_max($geometry))"/>
      <rendering drawLabels="1" displayAll="0" obstacle="0" obstacleType="1" obstacleFactor="1" fontMaxPixelSize="10000" fontMinPixelSize="0" fontLimitPixelSize="0" limitNumLabels="0" maxNumLabels="2000" scaleVisibility="0" upsidedownLabels="0" unplacedVisibility="0" labelPerPart="0" mergeLines="0" minFeatureSize="0" zIndex="0"/>
    </settings>
  </labeling>
  <blendMode>0</blendMode>
  <featureBlendMode>0</featureBlendMode>
  <layerGeometryType>2</layerGeometryType>
  <previewExpression>"sheet" || ': ' || coalesce(map_get(map('accepted', /*tr*/'Accepted', 'rejected', /*tr*/'Rejected', 'undecided', /*tr*/'Undecided', 'no_seams', /*tr*/'No seams'), "verdict"), '')</previewExpression>
  <fieldWords>
    <field names="verdict">
      <item value="accepted" label="Accepted"/>
      <item value="rejected" label="Rejected"/>
      <item value="undecided" label="Undecided"/>
      <item value="no_seams" label="No seams"/>
    </field>
  </fieldWords>
</qgis>
