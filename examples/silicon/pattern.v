// A screen of 640 x 480 pixels at 60 Hz, on which fbm of simplex noise scrolls: 64 pixels to a cell, a pixel a frame.
// The module hn_fbm2 is what `make` writes by tools/pick. LATENCY is what the comment above that module states.
`default_nettype none

module pattern #(
    parameter LATENCY = 2
) (
    input wire clock,  // 25 MHz
    output wire [7:0] grey,
    output wire across,  // the synchronisation of lines: low in a pulse
    output wire down,    // that of frames
    output wire shown    // whether the pixel is on the screen
);
  // The pixel, and how far the picture has scrolled. A line has 800 clocks, and a frame 525 lines.
  reg [9:0] x, y;
  reg [31:0] scroll;
  initial begin
    x = 0;
    y = 0;
    scroll = 0;
  end
  wire ends = x == 10'd799;
  always @(posedge clock) begin
    x <= ends ? 10'd0 : x + 10'd1;
    if (ends) y <= y == 10'd524 ? 10'd0 : y + 10'd1;
    if (ends && y == 10'd524) scroll <= scroll + 32'd1;
  end

  // The place of a whole position, as hn_place(ivec2(at_x, y), 1, 64) makes it.
  wire [31:0] at_x = {22'd0, x} + scroll;
  wire signed [22:0] value;
  hn_fbm2 noise (
      .clock(clock),
      .cell_x({{6{at_x[31]}}, at_x[31:6]}),
      .cell_y({28'd0, y[9:6]}),
      .fraction_x({at_x[5:0], 14'd0}),
      .fraction_y({y[5:0], 14'd0}),
      .rest_x(4'd0),
      .rest_y(4'd0),
      .value(value)
  );

  // 0 is the middle grey, and 1/2 is white. What is beyond takes the nearer end.
  wire signed [9:0] level = $signed(value[22:13]) + 10'sd128;
  wire unused = &{1'b0, value[12:0]};
  assign grey = level < 0 ? 8'd0 : level > 255 ? 8'd255 : level[7:0];

  // The pulses wait for the noise.
  wire [2:0] pulses = {x < 640 && y < 480, !(y >= 490 && y < 492), !(x >= 656 && x < 752)};
  reg [3 * LATENCY - 1:0] waiting;
  always @(posedge clock) waiting <= {waiting[3 * LATENCY - 4:0], pulses};
  assign {shown, down, across} = waiting[3 * LATENCY - 1:3 * LATENCY - 3];
endmodule

`default_nettype wire
