// Turns the assembly of a result in the browser: fields, load steps, parts. What it shows is in the page itself.
(async function () {
  'use strict';
  const element = (id) => document.getElementById(id);
  const model = JSON.parse(element('model').textContent);

  /** The numbers of the page: base64 of deflated little-endian 32-bit words. */
  async function unpack(text) {
    const bytes = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
    return new Response(stream).arrayBuffer();
  }
  const buffer = await unpack(element('data').textContent);
  const floats = ([offset, count]) => new Float32Array(buffer, 4 * offset, count);
  const integers = ([offset, count]) => new Uint32Array(buffer, 4 * offset, count);

  const core = vtk.Rendering.Core;
  const view = vtk.Rendering.Misc.vtkGenericRenderWindow.newInstance({ background: [1, 1, 1] });
  view.setContainer(element('view'));
  view.resize();
  window.addEventListener('resize', view.resize);
  const renderer = view.getRenderer();
  const table = core.vtkColorTransferFunction.newInstance();

  /** A block of the model as VTK has it. */
  function show(block) {
    const data = vtk.Common.DataModel.vtkPolyData.newInstance();
    const points = floats(block.points);
    data.getPoints().setData(new Float32Array(points), 3);
    data.getPolys().setData(integers(block.polys));
    const mapper = core.vtkMapper.newInstance({ interpolateScalarsBeforeMapping: true });
    mapper.setInputData(data);
    mapper.setLookupTable(table);
    mapper.setUseLookupTableScalarRange(true);
    if (block.isInterface) {
      mapper.setResolveCoincidentTopologyToPolygonOffset();
      mapper.setRelativeCoincidentTopologyPolygonOffsetParameters(-4, -4);
    }
    const actor = core.vtkActor.newInstance();
    actor.setMapper(mapper);
    actor.getProperty().setColor(...block.colour);
    actor.getProperty().setAmbient(0.35);
    actor.getProperty().setDiffuse(0.65);
    renderer.addActor(actor);
    const edges = vtk.Common.DataModel.vtkPolyData.newInstance();
    edges.getPoints().setData(new Float32Array(points), 3);
    edges.getLines().setData(integers(block.lines));
    const lines = core.vtkMapper.newInstance({ scalarVisibility: false });
    lines.setInputData(edges);
    const outline = core.vtkActor.newInstance();
    outline.setMapper(lines);
    outline.getProperty().setColor(0.25, 0.28, 0.32);
    outline.getProperty().setLineWidth(1.5);
    renderer.addActor(outline);
    return { block, points, data, edges, mapper, actor, outline, isVisible: true };
  }
  const shown = model.blocks.map(show);

  // The address may choose: page.html#field=contact_pressure&step=3
  const wanted = new URLSearchParams(location.hash.slice(1));
  const last = model.times.length - 1;
  const chosen = { field: model.field, step: last, scale: 1, opacity: null };
  if (model.fields.some((each) => each.name === wanted.get('field'))) chosen.field = wanted.get('field');
  if (wanted.has('step')) {
    const step = Number.parseInt(wanted.get('step'), 10) || 0;
    chosen.step = model.steps.filter((each) => each <= step).length - 1;
  }
  chosen.step = Math.max(0, chosen.step);
  for (const field of model.fields) element('field').add(new Option(field.label, field.name));
  element('field').value = chosen.field;
  element('step').max = last;
  element('step').value = chosen.step;

  function move(one) {
    const factor = model.scale * chosen.scale;
    const displacement = floats(one.block.displacements[chosen.step]);
    for (const data of [one.data, one.edges]) {
      const to = data.getPoints().getData();
      for (let i = 0; i < to.length; ++i) to[i] = one.points[i] + factor * displacement[i];
      data.getPoints().modified();
      data.modified();
    }
  }

  function paint(one, field) {
    const steps = one.block.fields[field.name];
    one.mapper.setScalarVisibility(Boolean(steps));
    const isBehind = field.isOfInterfaces && !one.block.isInterface;
    const opacity = chosen.opacity === null ? (field.isOfInterfaces ? 0.12 : 1) : chosen.opacity;
    one.actor.getProperty().setOpacity(one.block.isInterface ? 1 : opacity);
    one.actor.setVisibility(one.isVisible && (Boolean(steps) || isBehind));
    one.outline.setVisibility(one.isVisible && !one.block.isInterface);
    if (!steps) return;
    const values = floats(steps[chosen.step]);
    const scalars = vtk.Common.Core.vtkDataArray.newInstance({ name: field.name, values: new Float32Array(values) });
    one.data.getPointData().removeAllArrays();
    one.data.getCellData().removeAllArrays();
    if (field.isOfElements) {
      one.data.getCellData().setScalars(scalars);
      one.mapper.setScalarModeToUseCellData();
    } else {
      one.data.getPointData().setScalars(scalars);
      one.mapper.setScalarModeToUsePointData();
    }
    one.data.modified();
  }

  const text = (x) => String(Number(x.toPrecision(3)));

  function legend(field) {
    const [low, high] = field.limits;
    table.removeAllPoints();
    const stops = [];
    for (const [fraction, rgb] of field.colours) {
      table.addRGBPoint(low + fraction * (high - low), ...rgb);
      stops.push(`rgb(${rgb.map((c) => Math.round(255 * c))}) ${100 * fraction}%`);
    }
    table.setMappingRange(low, high);
    table.updateRange();
    element('colours').style.background = `linear-gradient(to top, ${stops.join(', ')})`;
    const names = field.names || [0, 1, 2, 3, 4].map((i) => text(low + (i / 4) * (high - low)));
    element('numbers').innerHTML = '';
    names.forEach((name, i) => {
      const label = document.createElement('span');
      label.textContent = name;
      label.style.top = `${100 * (1 - i / 4)}%`;
      element('numbers').append(label);
    });
  }

  function extremes(field) {
    let least = Infinity, largest = -Infinity;
    for (const one of shown) {
      const steps = one.block.fields[field.name];
      if (!steps || !one.isVisible) continue;
      for (const x of floats(steps[chosen.step])) {
        least = Math.min(least, x);
        largest = Math.max(largest, x);
      }
    }
    return least <= largest ? `${field.label}: ${text(least)} to ${text(largest)} in this step` : '';
  }

  function update() {
    const field = model.fields.find((each) => each.name === chosen.field);
    legend(field);
    for (const one of shown) {
      move(one);
      paint(one, field);
    }
    element('stepText').textContent = `${model.steps[chosen.step]} of ${model.steps[last]}, time ${text(model.times[chosen.step])}`;
    element('scaleText').textContent = text(model.scale * chosen.scale);
    element('extremes').textContent = extremes(field);
    element('opacity').value = chosen.opacity === null ? (field.isOfInterfaces ? 0.12 : 1) : chosen.opacity;
    view.getRenderWindow().render();
  }

  const listen = (id, name, read) => element(id).addEventListener('input', (event) => {
    chosen[name] = read(event.target.value);
    if (id === 'field') chosen.opacity = null;
    update();
  });
  listen('field', 'field', String);
  listen('step', 'step', Number);
  listen('scale', 'scale', Number);
  listen('opacity', 'opacity', Number);
  for (const one of shown) {
    const line = document.createElement('label');
    const box = document.createElement('input');
    line.className = 'part';
    box.type = 'checkbox';
    box.checked = true;
    box.addEventListener('input', () => {
      one.isVisible = box.checked;
      update();
    });
    line.append(box, ` ${one.block.name}`);
    element('blocks').append(line);
  }

  const camera = renderer.getActiveCamera();
  camera.setParallelProjection(true);
  camera.setPosition(...(model.isPlane ? [0, 0, 1] : [-0.55, -1, 0.85]));
  camera.setFocalPoint(0, 0, 0);
  camera.setViewUp(...(model.isPlane ? [0, 1, 0] : [0, 0, 1]));
  update();
  renderer.resetCamera();
  view.getRenderWindow().render();
  document.body.dataset.ready = 'yes';
}()).catch((error) => {
  document.getElementById('extremes').textContent = `This page cannot be shown: ${error.message}`;
  document.body.dataset.ready = 'failed';
});
